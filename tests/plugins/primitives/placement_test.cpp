// Where primitives are at a time and in a view, worked out by hand.
#include "primitives/seeing/placement.h"

#include <catch2/catch_test_macros.hpp>

#include <fmt/format.h>

#include "support/plugins.h"

namespace moire::test {
namespace {

// The curves that the plugin's scene shows, back to front.
class Written final : public CurveSink {
 public:
  void line(const LineCurve& c) override {
    text += fmt::format("{}: {:.12g} {:.12g} to {:.12g} {:.12g}, {:.12g} wide\n", c.element, c.from.x, c.from.y, c.to.x,
                        c.to.y, c.width);
  }
  void circle(const CircleCurve& c) override {
    text += fmt::format("{}: about {:.12g} {:.12g}, radius {:.12g}, {:.12g} wide\n", c.element, c.center.x, c.center.y,
                        c.radius, c.width);
  }
  std::string text;
};

std::string shown(const Changes& changes, ImageSize size = {80, 60}) {
  const ScenePlugin& plugin = scene_plugin("primitives");
  const Settings settings = changed(plugin.parameters, changes);
  Written written;
  plugin.make(settings)->frame(settings, size)->curves()->stream(written);
  return written.text;
}

Changes line_with(const Changes& more) {
  Changes changes{{"kind", std::string("line")}, {"length", 20.0}, {"angle_deg", 0.0}, {"x", 1.0}, {"y", 2.0}};
  changes.insert(changes.end(), more.begin(), more.end());
  return changes;
}

Changes circle_with(const Changes& more) {
  Changes changes{{"kind", std::string("circle")}, {"radius", 7.0}, {"width", 2.0}};
  changes.insert(changes.end(), more.begin(), more.end());
  return changes;
}

}  // namespace

TEST_CASE("the line and the circle lie where their settings say, from the image's middle") {
  CHECK(shown(line_with({})) == "1: 31 32 to 51 32, 1 wide\n");
  CHECK(shown(line_with({}), {81, 61}) == "1: 31.5 32.5 to 51.5 32.5, 1 wide\n");
  CHECK(shown(line_with({{"angle_deg", 90.0}, {"width", 3.0}})) == "1: 41 22 to 41 42, 3 wide\n");
  CHECK(shown(circle_with({{"x", -4.0}, {"y", 0.25}})) == "1: about 36 30.25, radius 7, 2 wide\n");
}

TEST_CASE("primitives move and turn about their middle with time") {
  const Changes motion{{"velocity.x", 3.0}, {"velocity.y", -1.0}, {"spin_deg", 45.0}, {"time", 2.0}};
  CHECK(shown(line_with(motion)) == "1: 47 20 to 47 40, 1 wide\n");
  CHECK(shown(circle_with(motion)) == "1: about 46 28, radius 7, 2 wide\n");
  // At time 0 to the last bit where it was written.
  CHECK(shown(line_with({{"spin_deg", 45.0}, {"x", 0.1}, {"length", 0.3}})) ==
        shown(line_with({{"x", 0.1}, {"length", 0.3}})));
}

TEST_CASE("views of primitives move, enlarge and turn about the middle of the image") {
  CHECK(shown(line_with({{"view.x", 5.0}, {"view.y", -1.0}})) == "1: 26 33 to 46 33, 1 wide\n");
  CHECK(shown(line_with({{"view.zoom", 2.0}})) == "1: 22 34 to 62 34, 2 wide\n");
  CHECK(shown(line_with({{"view.zoom", 2.0}, {"view.x", 1.0}, {"view.y", 2.0}})) == "1: 20 30 to 60 30, 2 wide\n");
  // Clockwise: what was right of the middle is below it.
  CHECK(shown(line_with({{"view.rotation_deg", 90.0}})) == "1: 38 21 to 38 41, 1 wide\n");
  CHECK(shown(circle_with({{"view.zoom", 0.5}, {"x", 8.0}})) == "1: about 44 30, radius 3.5, 1 wide\n");
}

TEST_CASE("widths stay what they are in pixels if they are not scaled") {
  const Changes hairlines{{"view.zoom", 10.0}, {"scale_widths", false}};
  CHECK(shown(line_with(hairlines)) == "1: -50 50 to 150 50, 1 wide\n");
  CHECK(shown(circle_with(hairlines)) == "1: about 40 30, radius 70, 2 wide\n");
}

TEST_CASE("the built-in kinds have as many primitives as asked for, in the image, and numbers as elements") {
  CHECK(shown({{"kind", std::string("circles")}, {"count", std::int64_t{2}}}, {200, 100}) ==
        "1: about 100 50, radius 24, 1 wide\n2: about 100 50, radius 48, 1 wide\n");
  CHECK(shown({{"kind", std::string("fan")}, {"count", std::int64_t{2}}, {"angle_deg", 0.0}}, {200, 100}) ==
        "1: 104 50 to 148 50, 1 wide\n2: 96 50 to 52 50, 1 wide\n");
  const auto random = [](std::int64_t count, std::int64_t seed) {
    return shown({{"kind", std::string("random")}, {"count", count}, {"seed", seed}});
  };
  CHECK(std::ranges::count(random(25, 1), '\n') == 25);
  CHECK(random(25, 1) != random(25, 2));
  CHECK(random(25, 1).starts_with(random(10, 1)));
  CHECK(random(0, 1).empty());
}

}  // namespace moire::test
