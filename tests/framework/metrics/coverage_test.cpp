// Coverage of blocks made by hand, against exact blocks made by hand.
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "framework/metrics/measured.h"
#include "metrics/registry.h"

namespace moire::test {

namespace {

struct Deposit {
  int x, y;
  Element element;
  double weight = 1;
};
using Deposits = std::vector<Deposit>;
using Values = std::map<std::string, double>;

constexpr Element a = 1, b = 2, c = 3, d = 4;

PixelBlock block(PixelArea area, const Deposits& deposits) {
  PixelBlock result(area, true);
  for (const Deposit& e : deposits) result.add(result.slot(e.x, e.y), e.element, e.weight, {});
  return result;
}

Picture picture(ImageSize size) {
  return {size, std::vector<Color>(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height))};
}

std::unique_ptr<Metric> coverage(const char* against) {
  Settings settings(coverage_description.parameters);
  settings.set("against", std::string(against));
  return make_coverage(settings);
}

// Of an image that is one block.
Values covered(const char* against, ImageSize size, const Deposits& own, const Deposits& exact,
               const Counters& counters = {}) {
  const auto metric = coverage(against);
  metric->begin(size);
  const PixelArea all{0, 0, size.width, size.height};
  metric->block(block(all, own), MergedBlock(block(all, exact)));
  return measured(*metric, picture(size), picture(size), counters);
}

}  // namespace

TEST_CASE("coverage says which exact content it is held against") {
  CHECK(coverage("column")->against() == Against::column);
  CHECK(coverage("pixel")->against() == Against::pixel);
}

TEST_CASE("the exact content itself has ratio 1, no leak and no weight error") {
  const Deposits exact{{0, 0, a, 0.25}, {0, 0, b, 0.75}, {0, 1, background}, {1, 0, c, 5}, {1, 1, a}};
  for (const char* against : {"column", "pixel"}) {
    const Values found = covered(against, {2, 2}, exact, exact);
    CHECK(found.at("coverage.ratio") == 1);
    CHECK(found.at("coverage.leak") == 0);
    CHECK(found.at("coverage.weight_error") == 0);
  }
}

TEST_CASE("against pixels, an element counts in each pixel where it is visible") {
  // One image column of two pixels. Visible: a above, c and d below. Sampled: a and the invisible b above, c below.
  const Values found = covered("pixel", {1, 2}, {{0, 0, a}, {0, 0, b}, {0, 1, c}}, {{0, 0, a}, {0, 1, c}, {0, 1, d}});
  CHECK(found.at("coverage.pixels") == 2);
  CHECK(found.at("coverage.visible") == 3);
  CHECK(found.at("coverage.sampled") == 2);
  CHECK(found.at("coverage.ratio") == 2.0 / 3);
  CHECK(found.at("coverage.leak") == 0.25);         // half of the upper pixel
  CHECK(found.at("coverage.weight_error") == 0.5);  // half of a pixel is wrong in both
}

TEST_CASE("against columns, an element counts once a column, in whichever of its pixels it is sampled") {
  // a is visible above and below, b below, and each is sampled in the other's place.
  const Deposits exact{{0, 0, a}, {0, 1, a, 0.5}, {0, 1, b, 0.5}};
  Values found = covered("column", {1, 2}, {{0, 0, b}, {0, 1, a}}, exact);
  CHECK(found.at("coverage.visible") == 2);
  CHECK(found.at("coverage.sampled") == 2);
  CHECK(found.at("coverage.ratio") == 1);
  CHECK(found.at("coverage.leak") == 0.5);           // leak and weight error are of pixels all the same
  CHECK(found.at("coverage.weight_error") == 0.75);  // 1 above, 0.5 below

  found = covered("column", {1, 2}, {{0, 0, c}, {0, 1, a}}, exact);
  CHECK(found.at("coverage.sampled") == 1);  // c is visible nowhere
  CHECK(found.at("coverage.ratio") == 0.5);
}

TEST_CASE("columns do not lend each other elements") {
  const Values found = covered("column", {2, 1}, {{0, 0, a}, {1, 0, a}}, {{0, 0, a}, {1, 0, b}});
  CHECK(found.at("coverage.visible") == 1);    // a column
  CHECK(found.at("coverage.sampled") == 0.5);  // a column
  CHECK(found.at("coverage.ratio") == 0.5);
}

TEST_CASE("the background is no element, but its weight counts") {
  Values found = covered("pixel", {1, 2}, {{0, 0, background, 0.25}, {0, 0, a, 0.75}, {0, 1, background}},
                         {{0, 0, a}, {0, 1, background}});
  CHECK(found.at("coverage.pixels") == 1);
  CHECK(found.at("coverage.visible") == 1);
  CHECK(found.at("coverage.sampled") == 1);
  CHECK(found.at("coverage.leak") == 0.125);
  CHECK(found.at("coverage.weight_error") == 0.125);

  found = covered("pixel", {1, 1}, {{0, 0, background}}, {{0, 0, background}});
  CHECK(found.at("coverage.weight_error") == 0);
  CHECK(std::isnan(found.at("coverage.ratio")));  // of nothing
}

TEST_CASE("steps and hits are those of the image, a column") {
  const Values found =
      covered("column", {2, 1}, {{0, 0, a}, {1, 0, a}}, {{0, 0, a}, {1, 0, a}}, {.queries = 9, .hits = 6, .steps = 10});
  CHECK(found.at("coverage.hits") == 3);
  CHECK(found.at("coverage.steps") == 5);
}

TEST_CASE("blocks may come in any order") {
  const Deposits left{{0, 0, a}, {1, 0, b}}, right{{2, 0, c}};
  const PixelArea left_area{0, 0, 2, 1}, right_area{2, 0, 1, 1};
  const Values whole = covered("column", {3, 1}, {{0, 0, a}, {1, 0, a}, {2, 0, c}}, {{0, 0, a}, {1, 0, b}, {2, 0, c}});
  const auto metric = coverage("column");
  metric->begin({3, 1});
  metric->block(block(right_area, right), MergedBlock(block(right_area, right)));
  metric->block(block(left_area, {{0, 0, a}, {1, 0, a}}), MergedBlock(block(left_area, left)));
  CHECK(measured(*metric, picture({3, 1}), picture({3, 1})) == whole);
}

}  // namespace moire::test
