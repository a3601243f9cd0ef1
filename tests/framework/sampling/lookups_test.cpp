#include "sampling/lookups.h"

#include <catch2/catch_test_macros.hpp>
#include <map>
#include <set>
#include <string>

namespace moire::test {

namespace {

using Weights = std::map<Element, double>;

// 4 x 4 texels, and 2 x 2 of the level above.
struct SmallTexture {
  std::vector<float> fine = std::vector<float>(48, 0.5F), coarse = std::vector<float>(12, 0.5F);
  Texture texture{{{fine.data(), 3, 4, 4}, {coarse.data(), 3, 2, 2}}, Wrap::repeat};
};

Weights deposited(const char* lookup, const SurfacePoint& point) {
  const SmallTexture small;
  Tally tally(1, true);
  make_lookup(lookup)->deposit(point, small.texture, 2, tally, 0);
  Weights weights;
  tally.for_each(0, [&](const Fragment& f) { weights[f.element] += f.weight; });
  return weights;
}

SurfacePoint place(double s, double t, int level = 0) {
  SurfacePoint point;
  point.textured = true;
  point.level = level;
  point.s = s;
  point.t = t;
  point.dt_dx = 1;
  return point;
}

}  // namespace

TEST_CASE("every lookup has a name of its own and can be made; nearest is first, and null") {
  std::set<std::string_view> names;
  for (const NamedSummary& lookup : lookups()) {
    CHECK(names.insert(lookup.name).second);
    CHECK_FALSE(lookup.summary.empty());
    CHECK((make_lookup(lookup.name) == nullptr) == (lookup.name == "nearest"));
  }
  CHECK(lookups().front().name == "nearest");
}

TEST_CASE("bilinear weighs the four nearest texels by the distance of their middles") {
  CHECK(deposited("bilinear", place(1.75, 2.25)) == Weights{{texel_element(0, 1, 1), 2 * 0.75 * 0.25},
                                                            {texel_element(0, 2, 1), 2 * 0.25 * 0.25},
                                                            {texel_element(0, 1, 2), 2 * 0.75 * 0.75},
                                                            {texel_element(0, 2, 2), 2 * 0.25 * 0.75}});
}

TEST_CASE("in a texel's middle bilinear sees that texel alone") {
  CHECK(deposited("bilinear", place(1.5, 2.5)) == Weights{{texel_element(0, 1, 2), 2}});
}

TEST_CASE("bilinear names texels beyond the border as such") {
  CHECK(deposited("bilinear", place(0, 0.5)) == Weights{{texel_element(0, -1, 0), 1}, {texel_element(0, 0, 0), 1}});
}

TEST_CASE("linear across weighs two texels along the axis that moves faster across the image") {
  SurfacePoint point = place(1.75, 2.25);
  CHECK(deposited("linear_across", point) ==
        Weights{{texel_element(0, 1, 1), 2 * 0.25}, {texel_element(0, 1, 2), 2 * 0.75}});
  point.ds_dx = -2;
  CHECK(deposited("linear_across", point) ==
        Weights{{texel_element(0, 1, 2), 2 * 0.75}, {texel_element(0, 2, 2), 2 * 0.25}});
}

TEST_CASE("lookups look at the level that the scene shows") {
  CHECK(deposited("bilinear", place(2, 1, 1)) == Weights{{texel_element(1, 0, 0), 1}, {texel_element(1, 1, 0), 1}});
  CHECK(deposited("linear_across", place(2, 2, 1)) ==
        Weights{{texel_element(1, 1, 0), 1}, {texel_element(1, 1, 1), 1}});
}

}  // namespace moire::test
