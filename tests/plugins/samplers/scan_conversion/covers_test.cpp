// Whole frames of curves: what covers what, against painting from back to front; and frames hard to draw.
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "kernels.h"
#include "sanitized.h"
#include "scan_converter.h"
#include "support/curve_frame.h"
#include "support/plugins.h"

namespace moire::test {
namespace {

using namespace scan_conversion;

constexpr ImageSize size{90, 70};

std::vector<Curve> many_curves(int count, std::uint64_t seed) {
  Numbers numbers(seed);
  std::vector<Curve> curves;
  for (int k = 0; k < count; ++k) {
    const auto channel = [&] { return static_cast<float>(numbers.real(0, 1)); };
    const Color color{channel(), channel(), channel()};
    const auto place = [&] { return Point{numbers.real(-20, 110), numbers.real(-20, 90)}; };
    const auto element = static_cast<Element>(k + 1);
    if (k % 3 == 2) {
      const Point center = place();
      curves.emplace_back(CircleCurve{element, color, center, k % 4 == 0 ? numbers.real(0, 3) : numbers.real(3, 40)});
    } else {
      const Point from = place();
      curves.emplace_back(LineCurve{element, color, from, k % 7 == 0 ? from : place()});
    }
  }
  return curves;
}

const std::vector<std::pair<std::string, Changes>>& samplers() {
  static const auto* const all = new std::vector<std::pair<std::string, Changes>>{
      {"bresenham", {}},
      {"gupta_sproull", {}},
      {"two_point", {}},
      {"two_point", {{"drawn", std::string("one_end")}, {"circles", std::string("table")}}},
      {"two_point", {{"circles", std::string("wide_table")}, {"method", std::string("direct")}}},
      {"two_point", {{"ends", std::string("real")}}},
      {"two_point", {{"ends", std::string("real")}, {"method", std::string("fujimoto_iwata")}}}};
  return *all;
}

}  // namespace

TEST_CASE("covers are blended in painter's order, in front first") {
  struct Paint {
    Element element;
    Color color;
  };
  Numbers numbers(1);
  const std::uint32_t full = 255;
  const Color sky{0.25F, 0.5F, 0.75F};
  std::vector<Paint> paints;
  for (Element k = 0; k < 40; ++k) {
    paints.push_back({k + 1, {static_cast<float>(numbers.real(0, 1)), static_cast<float>(numbers.real(0, 1)), 0.5F}});
  }
  PixelBlock block({3, 5, 6, 4}, true);
  Covers covers(block, full);
  struct Exact {
    long double r = 0.25L, g = 0.5L, b = 0.75L;
    std::vector<Element> elements;
  };
  std::vector<Exact> exact(block.slots());
  for (std::uint32_t k = 0; k < 40; ++k) {
    for (int n = 0; n < 10; ++n) {
      const int x = 3 + static_cast<int>(numbers.integer(0, 5)), y = 5 + static_cast<int>(numbers.integer(0, 3));
      Exact& pixel = exact[block.slot(x, y)];
      if (!pixel.elements.empty() && pixel.elements.back() == k + 1) continue;
      const auto intensity = static_cast<std::uint32_t>(numbers.integer(0, 3) * 85);
      covers.add(x, y, k, intensity);
      if (intensity == 0) continue;
      const long double alpha = static_cast<long double>(intensity) / full;
      if (intensity == full) pixel.elements.clear();
      pixel.elements.push_back(k + 1);
      pixel.r += alpha * (paints[k].color.r - pixel.r);
      pixel.g += alpha * (paints[k].color.g - pixel.g);
      pixel.b += alpha * (paints[k].color.b - pixel.b);
    }
  }
  covers.deposit(block, sky, [&](std::uint32_t k) -> const Paint& { return paints[k]; });
  for (std::size_t slot = 0; slot < block.slots(); ++slot) {
    const auto& sum = block.sum(slot);
    CHECK(std::abs(sum.weight - 1) <= 1e-14);
    CHECK(std::abs(static_cast<double>(sum.r - exact[slot].r)) <= 1e-14);
    CHECK(std::abs(static_cast<double>(sum.g - exact[slot].g)) <= 1e-14);
    CHECK(std::abs(static_cast<double>(sum.b - exact[slot].b)) <= 1e-14);
    std::vector<Element> elements;
    block.for_each(slot, [&](const Fragment& f) {
      if (f.element != background) elements.insert(elements.begin(), f.element);
    });
    CHECK(elements == exact[slot].elements);
  }
}

TEST_CASE("a pixel under a thousand covers keeps weights that are positive and sum to 1") {
  PixelBlock block({0, 0, 1, 1}, true);
  Covers covers(block, 255);
  for (std::uint32_t k = 0; k < 1000; ++k) covers.add(0, 0, k, 254);
  const struct {
    Element element = 1;
    Color color;
  } paint;
  covers.deposit(
      block, {}, [&](std::uint32_t) -> const auto& { return paint; });
  CHECK(std::abs(block.weight(0) - 1) <= 1e-14);
  block.for_each(0, [](const Fragment& f) { CHECK(f.weight > 0); });
}

TEST_CASE("frames of curves are painted curve over curve, by every sampler") {
  const std::vector<Curve> curves = many_curves(60, 2);
  const Color sky{0.1F, 0.2F, 0.3F};
  const CurveFrame frame(size, curves, sky);
  for (const auto& [name, changes] : samplers()) {
    CAPTURE(name, changes.size());
    const Rendered image = rendered(*sampler(name, changes), frame);
    // Each curve alone in white on black is what it covers.
    std::vector<std::vector<double>> alphas;
    for (const Curve& curve : curves) {
      Curve white = curve;
      std::visit([](auto& c) { c.color = {1, 1, 1}; }, white);
      const Rendered alone = rendered(*sampler(name, changes), CurveFrame(size, {white}));
      auto& alpha = alphas.emplace_back();
      for (const Content& pixel : alone.pixels) {
        alpha.push_back(pixel.fragments.front().element == background ? 0 : pixel.fragments.front().weight);
      }
    }
    double worst = 0;
    for (std::size_t p = 0; p < image.pixels.size(); ++p) {
      long double red = sky.r, green = sky.g;
      for (std::size_t k = 0; k < curves.size(); ++k) {
        const Color color = std::visit([](const auto& c) { return c.color; }, curves[k]);
        red += alphas[k][p] * (color.r - red);
        green += alphas[k][p] * (color.g - green);
      }
      worst = std::max({worst, static_cast<double>(std::abs(image.pixels[p].color.r - red)),
                        static_cast<double>(std::abs(image.pixels[p].color.g - green))});
      CHECK(std::abs(image.pixels[p].weight - 1) <= 1e-12);
    }
    // Colours are floats.
    CHECK(worst <= 0x1p-24);
  }
}

TEST_CASE("frames of curves do not depend on blocks, threads or recording") {
  const CurveFrame frame(size, many_curves(150, 3), {0.1F, 0.2F, 0.3F});
  for (const auto& [name, changes] : samplers()) {
    CAPTURE(name, changes.size());
    const auto made = sampler(name, changes);
    const Rendered image = rendered(*made, frame);
    for (const Blocks order : {Blocks::columns, Blocks::rows}) {
      for (const int width : {1, 7, 32, size.width}) {
        for (const int threads : {1, 2}) {
          if (sanitized && width != 7) continue;
          const bool recording = order == Blocks::columns && width == 7;
          CHECK(first_difference(image, rendered(*made, frame, nullptr, {threads, width, recording, order})) == "");
        }
      }
    }
  }
}

TEST_CASE("a frame without curves is background, and lines end in the pixels they name") {
  const Color sky{0.5F, 0.25F, 0};
  for (const auto& [name, changes] : samplers()) {
    const Rendered image = rendered(*sampler(name, changes), CurveFrame({8, 8}, {}, sky));
    for (const Content& pixel : image.pixels) {
      CHECK(pixel.color == sky);
      CHECK(pixel.fragments.size() == 1);
    }
  }
  const CurveFrame line({30, 30}, {LineCurve{7, {1, 1, 1}, {10.5, 20.5}, {17.5, 20.5}}});
  const Rendered image = rendered(*sampler("two_point"), line);
  for (int x = 0; x < 30; ++x) CHECK(image.at(x, 20).color.r == (x >= 10 && x <= 17 ? 1.0F : 0.0F));
}

TEST_CASE("curves far beyond what pixels are counted in leave a picture of background or of themselves") {
  std::vector<Curve> curves;
  for (const double far : {1e5, 3e9, 1e13, 1e100, 1e308}) {
    curves.emplace_back(LineCurve{1, {1, 0, 0}, {-far, -far / 3}, {far, far / 2}});
    curves.emplace_back(LineCurve{2, {1, 0, 0}, {far, 3}, {far, 4}});
    curves.emplace_back(LineCurve{3, {1, 0, 0}, {3, -far}, {4, 2}});
    curves.emplace_back(CircleCurve{4, {0, 1, 0}, {far, 20}, far});
    curves.emplace_back(CircleCurve{5, {0, 1, 0}, {20, 20}, far});
    curves.emplace_back(CircleCurve{6, {0, 1, 0}, {-far, far}, 2});
  }
  const CurveFrame frame({40, 40}, curves);
  for (const auto& [name, changes] : samplers()) {
    CAPTURE(name);
    const Rendered image = rendered(*sampler(name, changes), frame);
    for (const Content& pixel : image.pixels) CHECK(std::abs(pixel.weight - 1) <= 1e-12);
    // The line down from the top.
    CHECK(image.at(3, 0).color.r + image.at(4, 0).color.r > 0);
  }
}

}  // namespace moire::test
