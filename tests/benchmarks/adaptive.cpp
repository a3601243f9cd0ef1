#include "adaptive.h"

#include <cmath>

#include <fmt/format.h>

#include "interleaved.h"
#include "metrics/picture.h"
#include "terrain_views.h"

namespace moire::benchmark {

namespace {

using Changes = std::vector<std::pair<std::string, Value>>;

constexpr ImageSize size{256, 256};
constexpr double pixels = size.width * size.height;

struct Spent {
  double samples;  // a pixel
  double error;    // RMSE of linear light, full scale 1
  double ms;
};

// A drawing with its exact picture.
class Bench {
 public:
  Bench(const Catalog& catalog, const std::string& file) : catalog_(catalog) {
    const Plugin* plugin = catalog.find(Kind::scene, "cartoon");
    Settings settings(plugin->parameters());
    settings.set("file", file);
    scene_ = plugin->scene->make(settings);
    frame_ = scene_->frame(settings, size);
    exact_ = render_picture(*contender(catalog, "area", {{"method", std::string("exact")}}), *frame_, 0, 1, one_);
    for (const std::int64_t n : {2, 3, 4, 6, 8, 12, 16, 24, 32}) uniform_.push_back(spent("jittered", {{"n", n}}));
  }

  Spent spent(const std::string& type, const Changes& changes) const {
    const auto made = contender(catalog_, type, changes);
    Spent result{};
    const auto t = interleaved({{type,
                                 [&] {
                                   std::vector<Counters> blocks(one_.blocks(size));
                                   one_.render(*made->begin(*frame_, 1), *frame_, false,
                                               [&](std::size_t k, const PixelBlock& b) { blocks[k] = b.counters; });
                                   Counters all;
                                   for (const Counters& block : blocks) all += block;
                                   result.samples = static_cast<double>(all.queries) / pixels;
                                 }}},
                               1);
    result.ms = t[0].median();
    result.error = root_mean_square(differences(render_picture(*made, *frame_, 0, 1, one_), exact_, Space::linear)) /
                   levels_of_full_scale;
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
  const Workers one_{1};
  std::unique_ptr<Scene> scene_;
  std::unique_ptr<Frame> frame_;
  Picture exact_;
  std::vector<Spent> uniform_;  // jittered, more and more points
};

}  // namespace

void run_adaptive(const Catalog& catalog) {
  fmt::print("Adaptive sampling, {} x {} pixels: samples a pixel, RMSE (0 .. 1), samples that jitter needs for it.\n",
             size.width, size.height);
  for (const auto& [name, file] : {std::pair<const char*, std::string>{"cartoon, >= 30 x at .0015", ""},
                                   {"thin features, >= 10 x from quarters of a pixel", MOIRE_THIN_FEATURES}}) {
    fmt::print("  {}\n", name);
    const Bench bench(catalog, file);
    bench.print("jittered 4 x 4", "jittered", {});
    bench.print("jittered 16 x 16", "jittered", {{"n", std::int64_t{16}}});
    for (const std::int64_t depth : {2, 4, 5}) {
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
