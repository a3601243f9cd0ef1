// The host's part of a pattern of points: its weights, its lookups, its counters.
#include "sampling/pattern_sampler.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <utility>

#include "framework/sampling/pattern.h"
#include "sampling/lookups.h"

namespace moire::test {

namespace {

constexpr Color red{1, 0, 0}, green{0, 1, 0}, grey{0.5F, 0.5F, 0.5F};
constexpr Element left_half = 1, right_half = 2;

// The left half of each pixel is one element, the right half another. Where it is a surface, the left is the middle of
// texel (0, 0) of a grey texture and the right has none.
class Halves final : public Frame, public Surface {
 public:
  ImageSize size() const override { return {4, 4}; }
  void trace(std::span<const SamplePoint> points, std::span<Hit> hits, Counters& counters) const override {
    counters.queries += points.size();
    for (std::size_t k = 0; k < points.size(); ++k) hits[k] = at(points[k]);
  }
  const Surface* surface() const override { return this; }
  void locate(std::span<const SamplePoint> points, std::span<SurfacePoint> out, Counters& counters) const override {
    counters.queries += points.size();
    for (std::size_t k = 0; k < points.size(); ++k) {
      out[k] = {.hit = at(points[k]), .textured = at(points[k]).element == left_half, .s = 0.5, .t = 0.5};
    }
  }
  const Texture& texture() const override { return texture_; }

 private:
  static Hit at(const SamplePoint& point) {
    return point.x - std::floor(point.x) < 0.5 ? Hit{left_half, red} : Hit{right_half, green};
  }
  std::vector<float> texel_ = std::vector<float>(3, 0.5F);
  Texture texture_{{{texel_.data(), 3, 1, 1}}, Wrap::mirror};
};

// A plugin's way to make the sampler; a function pointer takes no captures.
std::vector<Points::Entry> points_of_plugin;

std::unique_ptr<Sampler> sampler(std::vector<Points::Entry> points) {
  points_of_plugin = std::move(points);
  const SamplerPlugin plugin{.summary = "", .source = "", .make_points = [](const Settings&) {
                               return std::unique_ptr<PointSampler>(std::make_unique<Pattern>(points_of_plugin));
                             }};
  return make_sampler(plugin, Settings());
}

PixelBlock rendered(const std::vector<Points::Entry>& points, const Lookup* lookup = nullptr) {
  const Halves frame;
  const auto made = sampler(points);
  PixelBlock block({1, 0, 3, 4}, true);
  made->begin({.frame = frame, .lookup = lookup})->render(block);
  return block;
}

std::vector<std::pair<Element, double>> fragments(const PixelBlock& block, int x, int y) {
  std::vector<std::pair<Element, double>> result;
  block.for_each(block.slot(x, y), [&](const Fragment& f) { result.emplace_back(f.element, f.weight); });
  return result;
}

}  // namespace

TEST_CASE("a pixel is the mean of its points by their weights") {
  const PixelBlock block = rendered({{0.25, 0.5, 1}, {0.75, 0.5, 3}});
  for (int x = 1; x < 4; ++x) {
    for (int y = 0; y < 4; ++y) {
      const std::size_t slot = block.slot(x, y);
      CHECK(block.weight(slot) == 1);
      CHECK(block.color(slot) == Color{0.25F, 0.75F, 0});
      CHECK(fragments(block, x, y) == std::vector<std::pair<Element, double>>{{left_half, 0.25}, {right_half, 0.75}});
    }
  }
  CHECK(block.counters.queries == 3 * 4 * 2);
}

TEST_CASE("negative weights take away") {
  const PixelBlock block = rendered({{0.25, 0.5, 3}, {0.75, 0.5, -1}});
  CHECK(block.weight(block.slot(2, 2)) == 1);
  CHECK(block.color(block.slot(2, 2)) == Color{1.5F, -0.5F, 0});
}

TEST_CASE("a lookup gives the colour where there is texture, the scene elsewhere") {
  const auto lookup = make_lookup("bilinear");
  const PixelBlock block = rendered({{0.25, 0.5, 1}, {0.75, 0.5, 1}}, lookup.get());
  CHECK(fragments(block, 1, 3) ==
        std::vector<std::pair<Element, double>>{{texel_element(0, 0, 0), 0.5}, {right_half, 0.5}});
  CHECK(block.color(block.slot(1, 3)) == 0.5F * grey + 0.5F * green);
  CHECK(block.counters.queries == 3 * 4 * 2);
}

}  // namespace moire::test
