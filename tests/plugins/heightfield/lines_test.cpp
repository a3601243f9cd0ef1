// What image lines through the nadir point report, held to single rays: each run must begin and end where a brute force
// says, to 1e-6 of a pixel, and the runs of a stretch must fill it. Shares no code with the scene.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

#include "message_of.h"
#include "plugins/heightfield/runs.h"
#include "plugins/heightfield/views.h"

namespace moire::test {
namespace {

const Changes independent{{"coherence", std::string("none")}};

Point along(Point from, Point to, double distance) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  return {from.x + (to.x - from.x) * distance / length, from.y + (to.y - from.y) * distance / length};
}

// The whole line through a point of the image towards the pole, as far as the image goes.
struct Line {
  Point from, to;
};

// Line k of 12 through the pole and a point of the image's rim, as one stretch that does not pass the pole.
Line radial_line(const View& view, Pole pole, int k) {
  const double w = view.size.width, h = view.size.height;
  const std::array<Point, 4> corners{Point{0, h}, Point{w, h}, Point{w, 0}, Point{0, 0}};
  const Point a = corners[static_cast<std::size_t>(k / 3)], b = corners[static_cast<std::size_t>((k / 3 + 1) % 4)];
  const double f = 0.13 + 0.31 * (k % 3);
  const Point rim{a.x + f * (b.x - a.x), a.y + f * (b.y - a.y)};
  const double sign = pole.w < 0 ? -1 : 1;
  const Point towards{sign * (pole.x - rim.x * pole.w), sign * (pole.y - rim.y * pole.w)};
  const double distance = std::hypot(towards.x, towards.y);
  const double reach = pole.w == 0 ? h : std::min(h, 0.999 * distance / std::abs(pole.w));
  return {rim, {rim.x + towards.x / distance * reach, rim.y + towards.y / distance * reach}};
}

bool rises(const View& view, Line line) {
  const auto slope = [&](Point p) {
    const Ray ray = ray_through(view, p.x, p.y);
    return ray.z / std::hypot(ray.x, ray.y);
  };
  return slope(line.from) < slope(line.to);
}

}  // namespace

TEST_CASE("the runs of a radial line begin and end where single rays change what they see") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  int runs = 0;
  for (const View& view : all_views(map)) {
    const auto frame = terrain.frame(view, independent);
    for (int k = 0; k < 12; ++k) {
      CAPTURE(view.caption, view.yaw, view.pitch, k);
      const Line line = radial_line(view, frame->lines()->pole().value(), k);
      const double length = std::hypot(line.to.x - line.from.x, line.to.y - line.from.y);
      Tally pieces(1, true);
      const std::array whole{0.0, length};
      follow(*frame, {line.from, line.to, whole}, pieces);
      Verdict verdict;
      const auto ray_at = [&](double place) {
        const Point p = along(line.from, line.to, place);
        return ray_through(view, p.x, p.y);
      };
      judge(map, view, runs_of(pieces, 0, 0, length, rises(view, line)), ray_at, verdict);
      CHECK(verdict.first_wrong == "");
      CHECK(std::abs(pieces.weight(0) - length) <= 1e-12 * length);
      runs += verdict.runs;
    }
  }
  CHECK(runs > 8'000);
}

TEST_CASE("a line through the nadir is seen the other way beyond it") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  int runs = 0;
  for (const double yaw : {13.0, 100.0, 222.0}) {
    for (const double pitch : {-85.0, -90.0}) {
      const View view{.caption = "", .x = 3.3, .y = 5.7, .z = 14, .yaw = yaw, .pitch = pitch, .fov = 70};
      const auto frame = terrain.frame(view, independent);
      const Pole pole = frame->lines()->pole().value();
      const Point nadir{pole.x / pole.w, pole.y / pole.w};
      for (const double angle : {0.0, 0.3, 1.1, std::numbers::pi / 2, 2.2, 4.0, 3 * std::numbers::pi / 2}) {
        CAPTURE(yaw, pitch, angle);
        // From 7.4 pixels before the nadir to 8.6 beyond it, in stretches of a pixel.
        const Point from{nadir.x - 7.4 * std::cos(angle), nadir.y - 7.4 * std::sin(angle)};
        const Point to{nadir.x + 8.6 * std::cos(angle), nadir.y + 8.6 * std::sin(angle)};
        std::vector<double> cuts;
        for (int i = 0; i <= 16; ++i) cuts.push_back(i);
        Tally pieces(16, true);
        follow(*frame, {from, to, cuts}, pieces);
        for (int i = 0; i < 16; ++i) {
          CHECK(std::abs(pieces.weight(static_cast<std::size_t>(i)) - 1) <= 1e-12);
          if (i == 7) continue;  // seen as two stretches
          Verdict verdict;
          const auto ray_at = [&](double place) {
            const Point p = along(from, to, place);
            return ray_through(view, p.x, p.y);
          };
          judge(map, view, runs_of(pieces, static_cast<std::size_t>(i), i, i + 1, i > 7), ray_at, verdict);
          CHECK(verdict.first_wrong == "");
          runs += verdict.runs;
        }
      }
    }
  }
  CHECK(runs > 600);
}

TEST_CASE("a line that is neither upright nor radial is refused") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  const View view{.caption = "", .x = 3.3, .y = 5.7, .z = 12, .pitch = -30};
  const auto frame = terrain.frame(view);
  Tally pieces(1, false);
  const std::array cuts{0.0, 1.0};
  CHECK(message_of([&] {
          follow(*frame, {{3, 18}, {9, 0}, cuts}, pieces);
        }) == "heightfield: an image line is neither upright nor through the nadir point");
}

}  // namespace moire::test
