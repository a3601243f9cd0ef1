// Where a drawing lies in the image, worked out by hand.
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include <fmt/format.h>

#include "seeing/placement.h"
#include "support/plugins.h"

namespace moire::test {
namespace {

std::string placed(const cartoon::Box& box, ImageSize size, Point p, const Changes& changes = {}) {
  const Settings settings = changed(scene_plugin("cartoon").parameters, changes);
  const Point q = cartoon::placement_of(box, settings, size).map(p);
  return fmt::format("{:.12g} {:.12g}", q.x, q.y);
}

}  // namespace

TEST_CASE("the view box is fitted into the image with its proportions, in the middle") {
  const cartoon::Box box{10, 20, 40, 20};
  CHECK(placed(box, {80, 40}, {10, 20}) == "0 0");
  CHECK(placed(box, {80, 40}, {50, 40}) == "80 40");
  CHECK(placed(box, {80, 100}, {10, 20}) == "0 30");
  CHECK(placed(box, {80, 100}, {50, 40}) == "80 70");
  CHECK(placed(box, {200, 40}, {30, 30}) == "100 20");
  CHECK(placed(box, {200, 40}, {10, 20}) == "60 0");
}

TEST_CASE("views move, enlarge and turn about the middle of the image") {
  const cartoon::Box box{0, 0, 40, 20};
  const ImageSize size{80, 40};
  CHECK(placed(box, size, {30, 10}, {{"view.x", 10.0}}) == "40 20");
  CHECK(placed(box, size, {20, 15}, {{"view.y", 5.0}}) == "40 20");
  CHECK(placed(box, size, {21, 10}, {{"view.zoom", 3.0}}) == "46 20");
  CHECK(placed(box, size, {30, 10}, {{"view.x", 10.0}, {"view.zoom", 8.0}}) == "40 20");
  // Clockwise: what was right of the middle is below it.
  CHECK(placed(box, size, {25, 10}, {{"view.rotation_deg", 90.0}}) == "40 30");
  CHECK(placed(box, size, {25, 10}, {{"view.rotation_deg", -90.0}}) == "40 10");
  CHECK(placed(box, size, {25, 10}, {{"view.rotation_deg", 60.0}}) == fmt::format("45 {:.12g}", 20 + std::sqrt(75)));
  CHECK(placed(box, size, {31, 10}, {{"view.x", 10.0}, {"view.rotation_deg", 90.0}, {"view.zoom", 2.0}}) == "40 24");
}

}  // namespace moire::test
