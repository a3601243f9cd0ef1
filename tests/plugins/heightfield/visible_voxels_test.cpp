// The exact picture of a terrain: its pieces held to single rays of the brute force, to boxes cut out of pixels one
// after another, and to their own sum.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <fmt/format.h>
#include <moire/random.h>

#include "plugins/heightfield/box_clipper.h"
#include "plugins/heightfield/brute_force.h"
#include "plugins/heightfield/views.h"
#include "support/pieces.h"

namespace moire::test {
namespace {

Rectangle picture_of(const View& view) { return {0, 0, double(view.size.width), double(view.size.height)}; }

Pieces visible_pieces(const SmallTerrain& terrain, const View& view) {
  return pieces_of(*terrain.frame(view)->polygons(), picture_of(view));
}

Rendered exact(const Frame& frame, Manner manner = {}) {
  return rendered(*sampler("area", {{"method", std::string("exact")}}), frame, nullptr, manner);
}

// Areas in every pixel, pieces cut by its sides.
std::vector<std::map<Element, double>> areas_of(const Pieces& pieces, ImageSize size) {
  std::vector<std::map<Element, double>> areas(static_cast<std::size_t>(size.width * size.height));
  for (const Piece& piece : pieces.all) {
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    for (const Point p : piece.outline) {
      left = std::min(left, p.x), right = std::max(right, p.x), top = std::min(top, p.y),
      bottom = std::max(bottom, p.y);
    }
    for (int x = std::max(0, int(std::floor(left))); x < std::min(double(size.width), right); ++x) {
      for (int y = std::max(0, int(std::floor(top))); y < std::min(double(size.height), bottom); ++y) {
        const double area = std::abs(area_of(part_in_pixel(piece.outline, x, y)));
        areas[static_cast<std::size_t>(y * size.width + x)][piece.element] += area;
      }
    }
  }
  return areas;
}

double sum_of(const std::map<Element, double>& areas) {
  double sum = 0;
  for (const auto& [element, area] : areas) sum += area;
  return sum;
}

// Whether the picture shows nothing but ground by its geometry alone: every ray falls below the lowest ground within
// the far limit.
bool shows_ground_only(const Map& map, const View& view) {
  const double lowest = *std::min_element(map.heights.begin(), map.heights.end());
  for (const double x : {0.0, double(view.size.width)}) {
    for (const double y : {0.0, double(view.size.height)}) {
      const Ray ray = ray_through(view, x, y);
      if (!(ray.z < 0 && (view.z - lowest) / -ray.z * std::hypot(ray.x, ray.y) < view.far)) return false;
    }
  }
  return view.z > *std::max_element(map.heights.begin(), map.heights.end());
}

}  // namespace

// Points at random places in every pixel: none but those within 1e-9 of an edge may be held by another piece than the
// ray's, by two, or by none.
TEST_CASE("every ray sees the voxel in whose one piece its image point lies, and the sky where there is none") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  int judged = 0;
  for (const View& view : all_views(map)) {
    if (view.far > 100) continue;  // the same sweep, many boxes for the brute force
    const Pieces pieces = visible_pieces(terrain, view);
    int wrong = 0;
    std::string first_wrong;
    for (int x = 0; x < view.size.width; ++x) {
      for (int y = 0; y < view.size.height; ++y) {
        const Pixel pixel{.x = x, .y = y, .seed = 11};
        const Point p{x + random(pixel, 0, 0), y + random(pixel, 0, 1)};
        const std::vector<Element> seen = seen_by(map, view, ray_through(view, p.x, p.y));
        if (seen.size() != 1) continue;
        ++judged;
        std::vector<Element> held;
        for (const Piece& piece : pieces.all) {
          if (holds(piece.outline, p)) held.push_back(piece.element);
        }
        const bool right = seen[0] == background ? held.empty() : held == seen;
        wrong += right ? 0 : 1;
        if (!right && first_wrong.empty()) {
          first_wrong = fmt::format("({}, {}) sees {:x}, lies in {} pieces, {:x}", p.x, p.y, seen[0], held.size(),
                                    held.empty() ? 0 : held[0]);
        }
      }
    }
    CAPTURE(view.caption, first_wrong);
    CHECK(wrong == 0);
  }
  CHECK(judged > 30'000);
}

TEST_CASE("the pieces' areas sum to 1 in every pixel of the ground, and nowhere to more") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  int full = 0;
  for (const View& view : all_views(map)) {
    CAPTURE(view.caption);
    const bool ground_only = shows_ground_only(map, view);
    double least = 1, most = 0;
    for (const auto& areas : areas_of(visible_pieces(terrain, view), view.size)) {
      least = std::min(least, sum_of(areas));
      most = std::max(most, sum_of(areas));
    }
    CHECK(most <= 1 + 1e-9);
    if (ground_only) CHECK(least >= 1 - 1e-9);
    full += ground_only ? 1 : 0;
  }
  CHECK(full >= 20);
}

// Each box is cut out of what the boxes before it leave of a pixel, but for scraps of 1e-13, of which there are less
// than a thousand.
TEST_CASE("a voxel's weight in a pixel is the area that cutting out boxes one by one leaves it") {
  int compared = 0;
  for (const auto& [columns, rows, relief] : {std::tuple(2, 2, 3.0), std::tuple(4, 4, 1.5), std::tuple(3, 5, 6.0)}) {
    const Map map = rough_map(columns, rows, relief, 5);
    const SmallTerrain terrain(map);
    for (const double pitch : {-90.0, -70.0, -50.0, -40.0}) {
      for (const double yaw : {0.0, 33.0, 45.0, 190.0, 270.0}) {
        const View view{.caption = "",
                        .x = 1.3,
                        .y = 2.6,
                        .z = relief + 1.2,
                        .yaw = yaw,
                        .pitch = pitch,
                        .fov = 50,
                        .far = 60,
                        .size = {5, 4}};
        if (!shows_ground_only(map, view)) continue;
        CAPTURE(columns, relief, pitch, yaw);
        const Rendered image = exact(*terrain.frame(view));
        for (int x = 0; x < view.size.width; ++x) {
          for (int y = 0; y < view.size.height; ++y) {
            std::map<Element, double> expected = box_areas(map, view, x, y);
            std::map<Element, double> found;
            for (const Fragment& f : image.at(x, y).fragments) found[f.element] += f.weight;
            double worst = 0;
            for (const auto& [element, area] : expected) worst = std::max(worst, std::abs(found[element] - area));
            for (const auto& [element, area] : found) worst = std::max(worst, std::abs(expected[element] - area));
            CHECK(worst <= 1e-10);
            ++compared;
          }
        }
      }
    }
  }
  CHECK(compared >= 500);
}

// A sample that stands for a square of 1 / n is wrong at most where an edge crosses the square; an edge of a piece in
// the pixel crosses n (|dx| + |dy|) + 1 of them at the most.
TEST_CASE("weights are the shares of regular samples, but for squares that an edge crosses") {
  constexpr int n = 40;
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  for (const double pitch : {-60.0, -25.0, -5.0}) {
    const View view{.caption = "", .x = 3.3, .y = 5.7, .z = 10, .yaw = 20, .pitch = pitch, .size = {8, 6}};
    const Pieces pieces = visible_pieces(terrain, view);
    const Rendered image = exact(*terrain.frame(view));
    for (const auto& [x, y] : {std::pair(0, 5), std::pair(4, 3), std::pair(7, 2), std::pair(2, 4), std::pair(5, 5)}) {
      CAPTURE(pitch, x, y);
      std::map<Element, double> shares, tolerance, found;
      for (int i = 0; i < n * n; ++i) {
        const Ray ray = ray_through(view, x + (i % n + 0.5) / n, y + (i / n + 0.5) / n);
        shares[seen_by(map, view, ray).front()] += 1.0 / (n * n);
      }
      for (const Fragment& f : image.at(x, y).fragments) found[f.element] += f.weight;
      double all = 0;
      for (const Piece& piece : pieces.all) {
        const Outline part = part_in_pixel(piece.outline, x, y);
        double squares = 0;
        for (std::size_t k = 0; k < part.size(); ++k) {
          const Point a = part[k], b = part[(k + 1) % part.size()];
          squares += n * (std::abs(b.x - a.x) + std::abs(b.y - a.y)) + 1;
        }
        tolerance[piece.element] += squares / (n * n);
        all += squares / (n * n);
      }
      tolerance[background] = all;
      for (const auto& [element, share] : shares) CHECK(std::abs(found[element] - share) <= tolerance[element]);
      for (const auto& [element, weight] : found) CHECK(std::abs(shares[element] - weight) <= tolerance[element]);
    }
  }
}

TEST_CASE("the exact picture is the same to the bit in blocks of any width, wherever the eye looks") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  const std::vector<View> views = all_views(map);
  for (std::size_t k = 0; k < views.size(); k += 5) {
    View view = views[k];
    if (view.far > 100 || view.far < 1) continue;  // slow, each for its own reason, and the same code
    view.size.width += 20;                         // several wedges
    CAPTURE(view.caption);
    const auto frame = terrain.frame(view);
    const Rendered image = exact(*frame);
    for (const int width : {1, 7, view.size.width}) {
      CHECK(first_difference(image, exact(*frame, {.threads = 2, .block_width = width, .recording = width == 7})) ==
            "");
    }
  }
}

TEST_CASE("only a terrain that is seen as it is has polygons, and says so") {
  const SmallTerrain terrain(usual_map());
  const View view{.caption = "", .x = 3.3, .y = 5.7, .z = 9};
  const ScenePlugin& plugin = scene_plugin("heightfield");
  const auto answers = [&](const Changes& changes) {
    const bool said =
        (plugin.answers(changed(plugin.parameters, changes)) & Questions::polygons) == Questions::polygons;
    CHECK((terrain.frame(view, changes)->polygons() != nullptr) == said);
    return said;
  };
  CHECK(answers({}));
  CHECK(answers({{"coherence", std::string("none")}, {"skip", std::string("on")}}));
  CHECK(!answers({{"levels", std::string("floor")}}));
  CHECK(!answers({{"face", std::string("near")}}));
  CHECK(!answers({{"azimuth", std::string("column")}}));
  CHECK(!answers({{"weights", std::string("height")}}));
  CHECK(!answers({{"walk", std::string("major")}}));
}

// The far limit's circle, of 2 voxels, lies in the picture: of a flat ground looked at from straight above, the picture
// shows its disk.
TEST_CASE("the far limit is a circle") {
  const SmallTerrain terrain(flat_map(3, 3, 1));
  const View view{
      .caption = "", .x = 1.4, .y = 1.7, .z = 5, .yaw = 10, .pitch = -90, .fov = 60, .far = 2, .size = {30, 30}};
  double sum = 0;
  for (const auto& areas : areas_of(visible_pieces(terrain, view), view.size)) sum += sum_of(areas);
  const double radius = 2.0 / 4 * 15 / std::tan(30 * std::numbers::pi / 180);
  CHECK(std::abs(sum - std::numbers::pi * radius * radius) <= 1e-8);  // 1e-10 of a pixel all round
}

}  // namespace moire::test
