#include "metrics/merged.h"

#include <catch2/catch_test_macros.hpp>
#include <utility>

namespace moire {

namespace {

using Pairs = std::vector<std::pair<Element, double>>;

Pairs pairs(std::span<const ElementWeight> merged) {
  Pairs result;
  for (const ElementWeight& e : merged) result.emplace_back(e.element, e.weight);
  return result;
}

Pairs merged(const Pairs& deposits) {
  Tally tally(1, true);
  for (const auto& [element, weight] : deposits) tally.add(0, element, weight, {});
  std::vector<ElementWeight> out{{99, 1}};  // what was there before is gone
  merge(tally, 0, out);
  return pairs(out);
}

}  // namespace

TEST_CASE("fragments of one element become one, in rising order of elements, and sum to 1") {
  CHECK(merged({{7, 1}, {background, 2}, {3, 4}, {7, 1}}) == Pairs{{background, 0.25}, {3, 0.5}, {7, 0.25}});
}

TEST_CASE("an element of weight 0 is left out, and one whose weights cancel") {
  CHECK(merged({{5, 0}, {3, 2}}) == Pairs{{3, 1}});
  CHECK(merged({{5, 1}, {3, 2}, {5, -1}}) == Pairs{{3, 1}});
}

TEST_CASE("a slot without fragments has no elements") { CHECK(merged({}).empty()); }

TEST_CASE("weights are summed in the order of deposit, so that the sum has the same bits every time") {
  const double tiny = 0x1p-54;
  CHECK(merged({{1, 1}, {1, tiny}, {1, tiny}}).front().second == (1.0 / (1 + 2 * tiny)) + tiny + tiny);
  CHECK(merged({{2, 0.5}, {1, 0.25}, {2, 0.25}}) == merged({{1, 0.25}, {2, 0.5}, {2, 0.25}}));
}

TEST_CASE("a merged block has the elements of each pixel, image column by column") {
  PixelBlock block({3, 1, 2, 2}, true);
  block.add(block.slot(3, 2), 1, 2, {});
  block.add(block.slot(4, 1), 2, 1, {});
  block.add(block.slot(4, 1), 1, 3, {});
  const MergedBlock all(block);
  CHECK(pairs(all.pixel(block.slot(3, 1))).empty());
  CHECK(pairs(all.pixel(block.slot(3, 2))) == Pairs{{1, 1}});
  CHECK(pairs(all.pixel(block.slot(4, 1))) == Pairs{{1, 0.75}, {2, 0.25}});
  CHECK(pairs(all.pixel(block.slot(4, 2))).empty());
}

}  // namespace moire
