#include "adaptive.h"

#include <cmath>

#include <fmt/format.h>

#include "interleaved.h"
#include "metrics/picture.h"
#include "terrain_views.h"

namespace moire::benchmark {

namespace {

using Changes = std::vector<std::pair<std::string, Value>>;

struct Spent {
  double samples;  // a pixel
  double error;    // RMSE of linear light, full scale 1
  double ms;
};

// A drawing with its exact picture.
class Bench {
 public:
  // `uniform`: sides of the jittered grids between which savings are looked up.
  Bench(const Catalog& catalog, const std::string& file, double rotation_deg, int side,
        const std::vector<std::int64_t>& uniform)
      : catalog_(catalog), size_{side, side} {
    const Plugin* plugin = catalog.find(Kind::scene, "cartoon");
    Settings settings(plugin->parameters());
    settings.set("file", file);
    settings.set("view.rotation_deg", rotation_deg);
    scene_ = plugin->scene->make(settings);
    frame_ = scene_->frame(settings, size_);
    exact_ = render_picture(*contender(catalog, "area", {{"method", std::string("exact")}}), *frame_, 0, 1, one_);
    for (const std::int64_t n : uniform) uniform_.push_back(spent("jittered", {{"n", n}}));
  }

  Spent spent(const std::string& type, const Changes& changes) const {
    const auto made = contender(catalog_, type, changes);
    const auto pixels = static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height);
    Picture picture{size_, std::vector<Color>(pixels)};
    std::vector<Counters> blocks(one_.blocks(size_));
    const double ms = once([&] {
      one_.render(*made->begin(*frame_, 1), *frame_, false, [&](std::size_t k, const PixelBlock& block) {
        blocks[k] = block.counters;
        put(block, picture);
      });
    });
    Counters all;
    for (const Counters& block : blocks) all += block;
    const double error = root_mean_square(differences(picture, exact_, Space::linear)) / levels_of_full_scale;
    const Spent result{static_cast<double>(all.queries) / static_cast<double>(pixels), error, ms};
    return result;
  }

  void print(const char* name, const std::string& type, const Changes& changes) const {
    const Spent own = spent(type, changes);
    const Spent equal = jittered_at(own.error);
    fmt::print("    {:<44} {:7.2f} samples  rmse {:.5f}  {:5.1f} x fewer than jittered  {:7.1f} ms, {:4.1f} x faster\n",
               name, own.samples, own.error, equal.samples / own.samples, own.ms, equal.ms / own.ms);
  }

 private:
  // Between measured grids, along a power law.
  Spent jittered_at(double error) const {
    std::size_t k = 1;
    while (k + 1 < uniform_.size() && uniform_[k].error > error) ++k;
    const Spent &few = uniform_[k - 1], &many = uniform_[k];
    const double part = std::log(few.error / error) / std::log(few.error / many.error);
    const auto between = [part](double a, double b) { return a * std::pow(b / a, part); };
    return {between(few.samples, many.samples), error, between(few.ms, many.ms)};
  }

  const Catalog& catalog_;
  const ImageSize size_;
  const Workers one_{1};
  std::unique_ptr<Scene> scene_;
  std::unique_ptr<Frame> frame_;
  Picture exact_;
  std::vector<Spent> uniform_;  // jittered, more and more points
};

}  // namespace

void run_adaptive(const Catalog& catalog) {
  struct Drawing {
    const char* name;
    std::string file;
    double rotation_deg;
    int side;
    std::vector<std::int64_t> uniform;
  };
  const Drawing drawings[] = {
      {"cartoon, >= 30 x at .0015", "", 0, 1024, {2, 4, 8, 16}},
      {"cartoon, turned so that none of its edges lie along the lattice", "", 7, 1024, {2, 4, 8, 16}},
      {"cartoon, small", "", 0, 256, {2, 4, 8, 16, 24}},
      {"thin features, >= 10 x from quarters of a pixel", MOIRE_THIN_FEATURES, 0, 256, {2, 4, 8, 16, 24}}};
  fmt::print("Adaptive sampling: samples a pixel, RMSE (0 .. 1), samples and time that jitter needs for it.\n");
  for (const auto& [name, file, rotation_deg, side, uniform] : drawings) {
    fmt::print("  {}, {} x {} pixels\n", name, side, side);
    const Bench bench(catalog, file, rotation_deg, side, uniform);
    bench.print("grid 16 x 16", "supersample", {{"n", std::int64_t{16}}, {"layout", std::string("grid")}});
    bench.print("jittered 4 x 4", "jittered", {});
    bench.print("jittered 16 x 16", "jittered", {{"n", std::int64_t{16}}});
    for (const std::int64_t depth : {2, 4, 5, 6}) {
      for (const char* first : {"1", "2", "4"}) {
        const std::string caption = fmt::format("corners, depth {}, first lattice 1/{} pixel", depth, first);
        bench.print(caption.c_str(), "adaptive", {{"depth", depth}, {"first", std::string(first)}});
      }
    }
    const std::string levels = "two_level";
    bench.print("two levels, 4 to 64", "adaptive", {{"method", levels}});
    bench.print("two levels, 4 to 64, no neighbours", "adaptive", {{"method", levels}, {"neighbours", false}});
    bench.print("two levels, 4 to 256", "adaptive", {{"method", levels}, {"fine", std::int64_t{16}}});
    for (const char* criterion : {"color", "element"}) {
      const std::string caption = fmt::format("corners, depth 4, criterion {}", criterion);
      bench.print(caption.c_str(), "adaptive", {{"criterion", std::string(criterion)}});
    }
  }
}

}  // namespace moire::benchmark
