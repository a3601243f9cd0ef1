#include "drawings.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <random>

#include <fmt/format.h>

#include "interleaved.h"
#include "metrics/picture.h"
#include "painted_layers.h"
#include "terrain_views.h"

#ifdef MOIRE_HAS_AGG
#include "agg_canvas.h"
#endif
#ifdef MOIRE_HAS_CAIRO
#include "cairo_canvas.h"
#endif

namespace moire::benchmark {

namespace {

constexpr const char* drawings[] = {"cats", "corn",  "cup",   "dinosaur", "fish",
                                    "frog", "house", "lemon", "pumpkin",  "tractor"};
constexpr int rounds = 15;

// A frame rendered as the host does it, into the same picture every time.
class Renderer {
 public:
  Renderer(std::unique_ptr<Contender> contender, const Frame& frame)
      : contender_(std::move(contender)),
        frame_(frame),
        picture_{frame.size(), std::vector<Color>(static_cast<std::size_t>(frame.size().width) *
                                                  static_cast<std::size_t>(frame.size().height))} {}

  void draw(const Workers& workers, const Rendering* previous = nullptr) {
    rendering_ = contender_->begin(frame_, 1, 0, previous);
    workers.render_runs(*rendering_, frame_, false,
                        [&](std::size_t, const PixelBlock& block) { put(block, picture_); });
  }
  const Rendering* rendering() const { return rendering_.get(); }
  const Picture& picture() const { return picture_; }

 private:
  std::unique_ptr<Contender> contender_;
  const Frame& frame_;
  Picture picture_;
  std::unique_ptr<Rendering> rendering_;
};

// All that are installed.
std::vector<std::unique_ptr<outside::Canvas>> canvases([[maybe_unused]] const outside::Painting& painting) {
  std::vector<std::unique_ptr<outside::Canvas>> result;
#ifdef MOIRE_HAS_CAIRO
  result.push_back(outside::cairo_canvas(painting));
#endif
#ifdef MOIRE_HAS_AGG
  result.push_back(outside::agg_canvas(painting));
#endif
  return result;
}

// Root of the mean square of all channels, in levels.
double error_of(const outside::Canvas& canvas, const Picture& truth) {
  std::vector<double> differences;
  for (int y = 0; y < truth.size.height; ++y) {
    for (int x = 0; x < truth.size.width; ++x) {
      const Color light = truth.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(truth.size.width) +
                                       static_cast<std::size_t>(x)];
      const Color own = canvas.codes(x, y), exact = outside::codes_of(light, Blend::linear);
      for (const float difference : {own.r - exact.r, own.g - exact.g, own.b - exact.b})
        differences.push_back(levels_of_full_scale * difference);
    }
  }
  return root_mean_square(differences);
}

// What is aimed at, by the names that Means uses.
const std::map<std::string, std::string> goals = {{"sweep over Cairo", "<= 0.6"},   {"sweep over AGG", "<= 0.9"},
                                                  {"replay over Cairo", "<= 0.25"}, {"catmull over AGG", "<= 4"},
                                                  {"point over AGG", "<= 1"},       {"sweep over 16x16", "<= 1"},
                                                  {"one thread over two", ">= 1.7"}};

// Geometric means over all drawings and sizes.
class Means {
 public:
  void add(const std::string& name, double value) {
    logs_[name].first += std::log(value);
    ++logs_[name].second;
  }
  void print() const {
    for (const auto& [name, sum] : logs_) {
      const auto goal = goals.find(name);
      fmt::print("    {:<40} {:.3f}   {}\n", name, std::exp(sum.first / sum.second),
                 goal == goals.end() ? "" : goal->second);
    }
  }

 private:
  std::map<std::string, std::pair<double, int>> logs_;
};

std::unique_ptr<Contender> exact(const Catalog& catalog, const char* integrator) {
  return contender(catalog, "area", {{"method", std::string("exact")}, {"integrator", std::string(integrator)}});
}

// Discs of 24 edges, each a layer, anywhere: whether time grows with edges, and not with pixels times layers.
std::string discs(int count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  std::string json = R"({"view_box": [0, 0, 1024, 1024], "layers": [)";
  for (int k = 0; k < count; ++k) {
    json += fmt::format("{}{{\"color\": \"#{:06x}\", \"contours\": [[", k == 0 ? "" : ", ", random() & 0xffffff);
    const double x = 1024 * unit(random), y = 1024 * unit(random);
    for (int i = 0; i < 24; ++i) {
      const double angle = i * std::numbers::pi / 12;
      json += fmt::format("{}[{:.4f}, {:.4f}]", i == 0 ? "" : ", ", x + 12 * std::cos(angle), y + 12 * std::sin(angle));
    }
    json += "]]}";
  }
  return json + "]}";
}

void growth(const Catalog& catalog) {
  const Plugin* plugin = catalog.find(Kind::scene, "cartoon");
  const Workers one(1);
  fmt::print("Layers: discs of 24 edges and 24 pixels across on 1024 x 1024 pixels; ms a frame (ns an edge).\n");
  for (const int layers : {10, 100, 1'000, 10'000, 100'000}) {
    const auto file = std::filesystem::temp_directory_path() / fmt::format("moire_discs_{}.json", layers);
    std::ofstream(file) << discs(layers);
    Settings settings(plugin->parameters());
    settings.set("file", file.string());
    const auto scene = plugin->scene->make(settings);
    std::filesystem::remove(file);
    const auto frame = scene->frame(settings, {1024, 1024});
    Renderer sweep(exact(catalog, "sweep"), *frame), prepared(exact(catalog, "prepared"), *frame),
        catmull(exact(catalog, "catmull"), *frame);
    const auto t = interleaved({{"sweep", [&] { sweep.draw(one); }},
                                {"prepare", [&] { prepared.draw(one); }},
                                {"catmull", [&] { catmull.draw(one); }}},
                               3);
    std::string line = fmt::format("  {:>6} layers", layers);
    const char* const names[] = {"sweep", "prepare", "catmull"};
    for (std::size_t k = 0; k < 3; ++k)
      line += fmt::format("  {} {:.2f} ({:.0f})", names[k], t[k].median(), 1e6 * t[k].median() / (24.0 * layers));
    fmt::print("{}\n", line);
  }
}

}  // namespace

void run_drawings(const Catalog& catalog) {
  const Plugin* plugin = catalog.find(Kind::scene, "cartoon");
  const Workers one(1), two(2);
  Means means;
  fmt::print("Drawings: ms a frame, one thread, to float pixels (peers: 8-bit); medians of {} rounds.\n", rounds);
  for (const char* drawing : drawings) {
    Settings settings(plugin->parameters());
    settings.set("file", std::string(std::getenv("MOIRE_DATA")) + "/cartoon/" + drawing + ".svg");
    const auto scene = plugin->scene->make(settings);
    // Errors are of averages of stored numbers, which is what peers make. Turning those into light afterwards is not
    // what is to be timed, so times are of light.
    settings.set("blend", std::string("as_stored"));
    const auto stored = plugin->scene->make(settings);
    for (const int side : {512, 1024}) {
      const ImageSize size{side, side};
      const auto frame = scene->frame(settings, size), stored_frame = stored->frame(settings, size);
      Renderer sweep(exact(catalog, "sweep"), *frame), prepared(exact(catalog, "prepared"), *frame),
          replayed(exact(catalog, "prepared"), *frame), catmull(exact(catalog, "catmull"), *frame);
      prepared.draw(one);
      Renderer point(contender(catalog, "point", {}), *frame);
      Renderer sixteen(contender(catalog, "supersample", {{"n", std::int64_t{16}}, {"layout", std::string("grid")}}),
                       *frame);
      auto others = canvases(outside::painting_of(*stored_frame));
      Renderer truth(exact(catalog, "sweep"), *stored_frame);
      truth.draw(one);

      std::vector<Work> works = {{"sweep", [&] { sweep.draw(one); }},
                                 {"replay", [&] { replayed.draw(one, prepared.rendering()); }},
                                 {"prepare", [&] { prepared.draw(one); }},
                                 {"catmull", [&] { catmull.draw(one); }},
                                 {"point", [&] { point.draw(one); }}};
      for (auto& peer : others) works.push_back({peer->name(), [&] { peer->draw(); }});
      const auto t = interleaved(works, rounds);
      const auto s = interleaved({{"16x16", [&] { sixteen.draw(one); }}}, 1);
      std::string line = fmt::format("  {:<9}{:>5}", drawing, side);
      for (std::size_t k = 0; k < works.size(); ++k) line += fmt::format("  {} {:.2f}", works[k].name, t[k].median());
      fmt::print("{}  16x16 {:.1f}; rmse", line, s[0].median());
      for (auto& peer : others) fmt::print(" {} {:.2f}", peer->name(), error_of(*peer, truth.picture()));
      fmt::print(" 16x16 {:.3f} of 255\n",
                 root_mean_square(differences(sixteen.picture(), sweep.picture(), Space::srgb)));
      for (std::size_t p = 5; p < works.size(); ++p) {
        for (std::size_t k = 0; k < 5; ++k)
          means.add(works[k].name + " over " + works[p].name, ratio(t[k], t[p]).median);
        if (ratio(t[0], t[p]).median > 2) fmt::print("    sweep takes more than twice as long as {}\n", works[p].name);
      }
      means.add("sweep over 16x16", t[0].median() / s[0].median());
      const auto w =
          interleaved({{"one", [&] { sweep.draw(one); }}, {"two", [&] { sweep.draw(two); }}}, rounds, Clock::wall);
      means.add("one thread over two", ratio(w[0], w[1]).median);
    }
  }
  means.print();
  growth(catalog);
}

}  // namespace moire::benchmark
