// `area` with method exact on polygons that do not overlap, held to polygons cut by straight lines pixel by pixel.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <map>

#include <moire/random.h>

#include "support/pieces.h"
#include "support/plugins.h"

namespace moire::test {
namespace {

constexpr Color sky{0.25F, 0.5F, 1};

// A picture of given pieces.
class Mosaic final : public Frame, private Polygons {
 public:
  Mosaic(ImageSize size, std::vector<Piece> pieces) : size_(size), pieces_(std::move(pieces)) {}

  ImageSize size() const override { return size_; }
  void trace(std::span<const SamplePoint>, std::span<Hit>, Counters&) const override {}
  const Polygons* polygons() const override { return this; }

 private:
  bool disjoint() const override { return true; }
  void stream(const Rectangle&, PolygonSink& sink) const override {
    constexpr std::uint32_t first = 0;
    for (const Piece& p : pieces_) sink.polygon({p.element, p.color, FillRule::nonzero, p.outline, {&first, 1}});
  }
  Color background_color() const override { return sky; }

  ImageSize size_;
  std::vector<Piece> pieces_;
};

Rendered exact(const Frame& frame, Manner manner = {}) {
  return rendered(*sampler("area", {{"method", std::string("exact")}}), frame, nullptr, manner);
}

std::map<Element, double> weights_of(const Content& pixel) {
  std::map<Element, double> weights;
  for (const Fragment& f : pixel.fragments) weights[f.element] += f.weight;
  return weights;
}

// A net over the rectangle whose inner knots are moved about; every other mesh is turned the other way round.
std::vector<Piece> net(Rectangle r, int columns, int rows, std::uint64_t seed) {
  const auto knot = [&](int i, int j) {
    const auto moved = [&](int at, int count, std::uint32_t dimension) {
      const Pixel pixel{.x = i, .y = j, .seed = seed};
      return at == 0 || at == count ? at : at + 0.9 * (random(pixel, 0, dimension) - 0.5);
    };
    return Point{r.x0 + (r.x1 - r.x0) * moved(i, columns, 0) / columns,
                 r.y0 + (r.y1 - r.y0) * moved(j, rows, 1) / rows};
  };
  std::vector<Piece> pieces;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const auto element = static_cast<Element>(1 + i * rows + j);
      Outline mesh{knot(i, j), knot(i + 1, j), knot(i + 1, j + 1), knot(i, j + 1)};
      if ((i + j) % 2 == 1) std::reverse(mesh.begin(), mesh.end());
      pieces.push_back({element, {static_cast<float>(i) / 7, static_cast<float>(j) / 7, 0.5F}, mesh});
    }
  }
  return pieces;
}

}  // namespace

// Sums of a few products of numbers up to 30 with an error of 2^-53 each: 1e-13 is ample.
TEST_CASE("every pixel gets the area that a polygon has in it, whether polygons are smaller than pixels or larger") {
  constexpr ImageSize size{19, 13};
  for (const auto& [columns, rows] : {std::pair(3, 2), std::pair(20, 15), std::pair(90, 70)}) {
    CAPTURE(columns, rows);
    // One net reaches beyond the picture on all sides; the other one leaves sky.
    for (const Rectangle r : {Rectangle{-3.3, -4.1, 25.7, 16.2}, Rectangle{2.21, 3.7, 14.6, 11.05}}) {
      const std::vector<Piece> pieces = net(r, columns, rows, 3);
      const Rendered image = exact(Mosaic(size, pieces));
      for (int x = 0; x < size.width; ++x) {
        for (int y = 0; y < size.height; ++y) {
          std::map<Element, double> expected;
          double rest = 1;
          for (const Piece& piece : pieces) {
            const double area = std::abs(area_of(part_in_pixel(piece.outline, x, y)));
            if (area > 0) expected[piece.element] = area;
            rest -= area;
          }
          if (rest > 1e-10) expected[background] = rest;
          auto found = weights_of(image.at(x, y));
          CAPTURE(x, y);
          CHECK(std::abs(image.at(x, y).weight - 1) <= 1e-10);
          for (const auto& [element, area] : expected) CHECK(std::abs(found[element] - area) <= 1e-13);
          for (const auto& [element, area] : found) CHECK(std::abs(expected[element] - area) <= 1e-13);
        }
      }
    }
  }
}

TEST_CASE("outlines need not be convex, and slivers keep their digits") {
  constexpr ImageSize size{8, 6};
  const Outline comb{{0.5, 0.5}, {7.5, 0.5}, {7.5, 5.5}, {6.1, 5.5}, {5.9, 1.2}, {4.2, 1.25},
                     {4.1, 5.7}, {3.3, 5.7}, {2.9, 1.1}, {1.6, 5.1}, {0.5, 5.1}};
  const double wide = 1e-9;
  const Outline sliver{{5.0, 1.5}, {5.0 + wide, 1.5}, {5.0 + wide, 4.5}, {5.0, 4.5}};
  const Rendered image = exact(Mosaic(size, {{1, {1, 0, 0}, comb}, {2, {0, 1, 0}, sliver}}));
  for (int x = 0; x < size.width; ++x) {
    for (int y = 0; y < size.height; ++y) {
      CAPTURE(x, y);
      auto found = weights_of(image.at(x, y));
      CHECK(std::abs(found[1] - std::abs(area_of(part_in_pixel(comb, x, y)))) <= 1e-14);
      const double of_sliver = x != 5 || y == 0 || y == 5 ? 0 : y == 1 || y == 4 ? wide / 2 : wide;
      CHECK(std::abs(found[2] - of_sliver) <= 1e-14 * 5);
    }
  }
}

TEST_CASE("a pixel that polygons fill has no background, and one without polygons nothing else") {
  const Rendered image = exact(Mosaic({4, 1}, net({0, 0, 2, 1}, 40, 40, 5)));
  for (int x = 0; x < 4; ++x) {
    const auto weights = weights_of(image.at(x, 0));
    CHECK(weights.count(background) == (x < 2 ? 0 : 1));
    CHECK((x < 2 || weights.at(background) == 1));
  }
  CHECK(image.at(3, 0).color.r == sky.r);
  CHECK(image.counters.queries == 4);
}

TEST_CASE("what polygons leave in a pixel is the same to the bit in blocks of any width") {
  const Mosaic mosaic({37, 29}, net({-3.3, -4.1, 45.7, 36.2}, 33, 17, 9));
  const Rendered image = exact(mosaic);
  for (const int width : {1, 2, 7, 37}) {
    for (const bool recording : {true, false}) {
      CHECK(first_difference(image, exact(mosaic, {.threads = 2, .block_width = width, .recording = recording})) == "");
    }
  }
}

}  // namespace moire::test
