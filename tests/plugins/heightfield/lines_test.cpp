// What image lines report, held to single rays: each run must begin and end where a brute force says, to 1e-6 of a
// pixel, and the runs of a stretch must fill it. Shares no code with the scene.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "message_of.h"
#include "plugins/heightfield/brute_force.h"
#include "plugins/heightfield/views.h"

namespace moire::test {
namespace {

constexpr double nearby = 1e-6;  // pixels

// The runs of one stretch, from its begin to its end in the order in which they lie there.
struct Run {
  Element element;
  double begin, end;  // pixels from the line's begin
};

std::vector<Run> runs_of(const Tally& pieces, std::size_t slot, double begin, double end, bool rises) {
  std::vector<Run> runs;
  double at = rises ? begin : end;
  pieces.for_each(slot, [&](const Fragment& f) {
    const double next = rises ? at + f.weight : at - f.weight;
    runs.push_back({f.element, std::min(at, next), std::max(at, next)});
    at = next;
  });
  return runs;
}

// Where along the line a run's content can be asked for: just inside its ends, and in its middle.
std::vector<double> probes(const Run& run) {
  const double length = run.end - run.begin;
  if (length < 4 * nearby) return {};
  return {run.begin + nearby, (run.begin + run.end) / 2, run.end - nearby};
}

bool contains(const std::vector<Element>& elements, Element element) {
  return std::find(elements.begin(), elements.end(), element) != elements.end();
}

struct Verdict {
  std::string first_wrong;
  int runs = 0;
};

// Judges runs by rays: ray_at(place) is the ray of a place on the line.
template <class RayAt>
void judge(const Map& map, const View& view, const std::vector<Run>& runs, RayAt ray_at, Verdict& verdict) {
  for (const Run& run : runs) {
    ++verdict.runs;
    for (const double place : probes(run)) {
      const std::vector<Element> seen = seen_by(map, view, ray_at(place));
      if (contains(seen, run.element) || !verdict.first_wrong.empty()) continue;
      verdict.first_wrong = fmt::format("element {:x} from {} to {}; a ray at {} sees {:x}", run.element, run.begin,
                                        run.end, place, seen.front());
    }
  }
}

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

// Upright stretches are seen in the vertical plane through their middle: a ray keeps its height and its advance along
// the axis along which the middle's ray advances more voxels, and is moved sideways into the plane.
class MiddlePlane {
 public:
  MiddlePlane(const View& view, double x, double low_y, double high_y)
      : view_(view), x_(x), middle_(ray_through(view, x, (low_y + high_y) / 2)) {
    steps_south_ = std::abs(middle_.y / view.spacing_y) > std::abs(middle_.x / view.spacing_x);
  }

  Ray ray(double y) const {
    const Ray ray = ray_through(view_, x_, y);
    if (steps_south_) return {ray.y * middle_.x / middle_.y, ray.y, ray.z};
    return {ray.x, ray.x * middle_.y / middle_.x, ray.z};
  }
  // Rise over advance in the plane.
  double slope(double y) const { return ray(y).z / advance(y); }
  double advance(double y) const {
    const Ray r = ray(y);
    return (r.x * middle_.x + r.y * middle_.y) / std::hypot(middle_.x, middle_.y);
  }
  // The camera's way forward over the ground; 0 at the height of the nadir and the zenith.
  double forward(double y) const {
    const Ray r = ray_through(view_, x_, y);
    const double yaw = view_.yaw * std::numbers::pi / 180;
    return r.x * std::cos(yaw) + r.y * std::sin(yaw);
  }

 private:
  const View& view_;
  double x_;
  Ray middle_;
  bool steps_south_;
};

}  // namespace

TEST_CASE("the runs of a radial line begin and end where single rays change what they see") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  std::vector<View> views = views_all_round();
  const std::vector<View> awkward = awkward_views(map);
  views.insert(views.end(), awkward.begin(), awkward.end());
  int runs = 0;
  for (const View& view : views) {
    const auto frame = terrain.frame(view, independent);
    for (int k = 0; k < 12; ++k) {
      CAPTURE(view.caption, view.yaw, view.pitch, k);
      const Line line = radial_line(view, frame->lines()->pole().value(), k);
      const double length = std::hypot(line.to.x - line.from.x, line.to.y - line.from.y);
      Tally pieces(1, true);
      frame->lines()->along(line.from, line.to, std::array{0.0, length}, nullptr, pieces);
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
        frame->lines()->along(from, to, cuts, nullptr, pieces);
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

TEST_CASE("the runs of an upright column's pixels are what single rays in the plane of each pixel's middle see") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  std::vector<View> views = views_all_round();
  const std::vector<View> awkward = awkward_views(map);
  views.insert(views.end(), awkward.begin(), awkward.end());
  int runs = 0, two_ways = 0, stretches = 0;
  for (const View& view : views) {
    const auto frame = terrain.frame(view, independent);
    const int height = view.size.height;
    std::vector<double> cuts;
    for (int i = 0; i <= height; ++i) cuts.push_back(i);
    for (const double x : {0.4, 7.3, view.size.width / 2.0, view.size.width - 0.27}) {
      Tally pieces(static_cast<std::size_t>(height), true);
      frame->lines()->along({x, static_cast<double>(height)}, {x, 0}, cuts, nullptr, pieces);
      for (int i = 0; i < height; ++i) {
        CAPTURE(view.caption, view.yaw, view.pitch, x, i);
        const auto slot = static_cast<std::size_t>(i);
        CHECK(std::abs(pieces.weight(slot) - 1) <= 1e-12);
        const MiddlePlane plane(view, x, height - i, height - i - 1);
        ++stretches;
        // Where a pixel looks both ways, it is seen as two stretches.
        if (plane.forward(height - i) * plane.forward(height - i - 1) <= 1e-12) {
          ++two_ways;
          continue;
        }
        const bool upward = plane.slope(height - i) < plane.slope(height - i - 1);
        Verdict verdict;
        judge(
            map, view, runs_of(pieces, slot, i, i + 1, upward), [&](double place) { return plane.ray(height - place); },
            verdict);
        CHECK(verdict.first_wrong == "");
        runs += verdict.runs;
      }
    }
  }
  CHECK(runs > 10'000);
  CHECK(two_ways < stretches / 50);
}

TEST_CASE("a line that is neither upright nor radial is refused") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  const View view{.caption = "", .x = 3.3, .y = 5.7, .z = 12, .pitch = -30};
  const auto frame = terrain.frame(view);
  Tally pieces(1, false);
  CHECK(message_of([&] {
          frame->lines()->along({3, 18}, {9, 0}, std::array{0.0, 1.0}, nullptr, pieces);
        }) == "heightfield: an image line is neither upright nor through the nadir point");
}

}  // namespace moire::test
