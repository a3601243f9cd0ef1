// The three exact integrators on whole drawings: the same picture from each, and the same bits however it is asked for.
// Colours are compared as sums of fragments, in double precision: pixels are kept as floats.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include "sanitized.h"
#include "support/plugins.h"

namespace moire::test {
namespace {

constexpr std::array drawings{"cats", "corn",  "cup",   "dinosaur", "fish",
                              "frog", "house", "lemon", "pumpkin",  "tractor"};

std::unique_ptr<Sampler> exact(const std::string& integrator) {
  return sampler("area", {{"method", std::string("exact")}, {"integrator", integrator}});
}

// A drawing of data:cartoon, or the one that is built in.
class Drawing {
 public:
  explicit Drawing(const std::string& name = {}) : plugin_(scene_plugin("cartoon")), settings_(plugin_.parameters) {
    if (!name.empty()) {
      const std::filesystem::path data = std::getenv("MOIRE_DATA");
      settings_.set("file", (data / "cartoon" / (name + ".svg")).string());
    }
    settings_.set("unsupported", std::string("skip"));
    scene_ = plugin_.make(settings_);
  }

  std::unique_ptr<Frame> frame(ImageSize size, const Changes& view = {}) const {
    Settings settings = settings_;
    for (const auto& [name, value] : view) settings.set(name, value);
    return scene_->frame(settings, size);
  }

 private:
  const ScenePlugin& plugin_;
  Settings settings_;
  std::unique_ptr<Scene> scene_;
};

struct LinearColor {
  double r = 0, g = 0, b = 0;
};

double difference(const LinearColor& p, const LinearColor& q) {
  return std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
}

struct Picture {
  std::vector<LinearColor> colors;  // row after row
  double largest_sum_error = 0;     // of a pixel's weights, from 1
};

Picture picture(const std::string& integrator, const Frame& frame) {
  const ImageSize size = frame.size();
  Picture result{
      std::vector<LinearColor>(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height))};
  const auto sampler = exact(integrator);
  const auto rendering = sampler->begin({.frame = frame});
  const Workers workers(1);
  workers.render(*rendering, frame, true, [&](std::size_t, const PixelBlock& block) {
    for (int x = block.x0; x < block.x0 + block.width; ++x) {
      for (int y = block.y0; y < block.y0 + block.height; ++y) {
        LinearColor& color = result.colors[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                                           static_cast<std::size_t>(x)];
        double sum = 0;
        block.for_each(block.slot(x, y), [&](const Fragment& f) {
          color.r += f.weight * f.color.r;
          color.g += f.weight * f.color.g;
          color.b += f.weight * f.color.b;
          sum += f.weight;
        });
        result.largest_sum_error = std::max(result.largest_sum_error, std::abs(sum - 1));
      }
    }
  });
  return result;
}

// A line for each pixel in which an integrator is off the sweep, or whose weights do not sum to 1.
std::string disagreements(const char* drawing, int side) {
  constexpr double bound = 1e-9;
  const auto frame = Drawing(drawing).frame({side, side});
  std::string lines;
  Picture sweep;
  for (const char* integrator : {"sweep", "prepared", "catmull"}) {
    Picture found = picture(integrator, *frame);
    if (found.largest_sum_error > 1e-12) {
      lines +=
          fmt::format("{} at {}: weights of {} miss 1 by {:.2g}\n", drawing, side, integrator, found.largest_sum_error);
    }
    if (sweep.colors.empty()) {
      sweep = std::move(found);
      continue;
    }
    for (std::size_t k = 0; k < found.colors.size(); ++k) {
      const double off = difference(found.colors[k], sweep.colors[k]);
      if (off <= bound) continue;
      const std::size_t width = static_cast<std::size_t>(side);
      lines += fmt::format("{} at {}: pixel ({}, {}) of {} is {:.2g} off that of sweep\n", drawing, side, k % width,
                           k / width, integrator, off);
    }
  }
  return lines;
}

}  // namespace

TEST_CASE("the three exact integrators draw the same pictures of all cartoons in all sizes") {
  if (!std::getenv("MOIRE_DATA")) SKIP("MOIRE_DATA is not set; point it at the data folder to test on its drawings");
  for (const int side : {256, 512, 1024, 2048}) {
    if (sanitized && side > 256) break;
    for (const char* drawing : drawings) CHECK(disagreements(drawing, side) == "");
  }
}

TEST_CASE("a prepared picture has the same bits with a previous rendering as without") {
  std::vector<const char*> names{""};
  if (std::getenv("MOIRE_DATA")) names.insert(names.end(), {"cats", "fish", "tractor"});
  const std::vector<Changes> views{{},
                                   {{"view.x", 4.13}},
                                   {{"view.x", 97.3}, {"view.y", -61.2}},
                                   {{"view.zoom", 1.01}},
                                   {{"view.zoom", 3.7}, {"view.x", 31.1}},
                                   {{"view.rotation_deg", 30.0}},
                                   {}};
  constexpr ImageSize size{160, 120};
  const auto prepared = exact("prepared");
  for (const char* name : names) {
    const Drawing drawing(name);
    std::unique_ptr<Rendering> previous;
    for (const Changes& view : views) {
      CAPTURE(name, &view - views.data());
      const auto frame = drawing.frame(size, view);
      auto continued = prepared->begin({.frame = *frame, .previous = previous.get()});
      CHECK(first_difference(rendered(*prepared, *frame), rendered(*continued, *frame)) == "");
      previous = std::move(continued);
    }
  }
}

TEST_CASE("exact pictures have the same bits in blocks of rows and of columns, recorded or not") {
  constexpr ImageSize size{150, 110};
  const auto frame = Drawing().frame(size, {{"view.rotation_deg", 10.0}});
  for (const char* integrator : {"sweep", "prepared", "catmull"}) {
    const auto sampler = exact(integrator);
    const Rendered image = rendered(*sampler, *frame);
    for (const Blocks order : {Blocks::columns, Blocks::rows}) {
      for (const bool recording : {true, false}) {
        for (const int block_width : {2, 13, 32, 150}) {
          CAPTURE(integrator, order == Blocks::rows, recording, block_width);
          const Manner manner{.block_width = block_width, .recording = recording, .order = order};
          CHECK(first_difference(image, rendered(*sampler, *frame, nullptr, manner)) == "");
        }
      }
    }
  }
}

}  // namespace moire::test
