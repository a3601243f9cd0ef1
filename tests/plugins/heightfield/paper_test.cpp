// The paper's choices of the scene `heightfield`: together, held to the paper's pseudo-code, and each alone, held to
// rays cut with every voxel.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numeric>

#include "plugins/heightfield/paper.h"
#include "plugins/heightfield/runs.h"
#include "plugins/heightfield/views.h"
#include "sampling/lookups.h"

namespace moire::test {
namespace {

Changes all_choices(const char* coherence = "resume") {
  return {{"walk", std::string("major")},
          {"azimuth", std::string("column")},
          {"face", std::string("near")},
          {"weights", std::string("height")},
          {"coherence", std::string(coherence)}};
}

Changes only(const char* choice, const char* value) {
  return {{choice, std::string(value)}, {"coherence", std::string("none")}};
}

// Directions all round but along the grid, where which voxel a ray on a grid line sees is a matter of rounding.
std::vector<View> paper_views() {
  std::vector<View> views = views_all_round();
  std::erase_if(views, [](const View& view) { return view.on_edges > 0 || view.pitch < -50 || view.fov > 60; });
  return views;
}

std::map<Element, double> merged(const Content& pixel) {
  std::map<Element, double> weights;
  for (const Fragment& f : pixel.fragments) weights[f.element] += f.weight;
  return weights;
}

// The largest difference of two pixels' weights.
double difference(const std::map<Element, double>& one, const std::map<Element, double>& other) {
  double largest = 0;
  const auto compare = [&](const auto& a, const auto& b) {
    for (const auto& [element, weight] : a) {
      const auto same = b.find(element);
      largest = std::max(largest, std::abs(weight - (same == b.end() ? 0 : same->second)));
    }
  };
  compare(one, other);
  compare(other, one);
  return largest;
}

void add(std::map<Element, double>& weights, const Wall* wall, bool interpolates, double weight) {
  if (!wall) {
    weights[background] += weight;
  } else if (!interpolates) {
    weights[wall->element] += weight;
  } else {
    for (const auto& [element, share] : interpolated(*wall)) weights[element] += share * weight;
  }
}

// Fig. 12 for one pixel; the sky keeps its length in the image.
std::map<Element, double> area_of_pixel(const PaperColumn& column, int y, bool interpolates) {
  const auto parts = column.seen_between(y + 1, y);
  double rise = 0, length = 0;
  for (const auto& part : parts) {
    rise += part.rise;
    length += part.length;
  }
  std::map<Element, double> weights;
  for (const auto& part : parts) add(weights, part.wall, interpolates, length * part.rise / rise);
  if (parts.empty() || length < 1 - 1e-9) add(weights, nullptr, interpolates, 1 - length);
  return weights;
}

// The largest difference of any pixel's weights from what `expected(column, y)` says.
template <class Expected>
double worst(const Map& map, const View& view, const Rendered& image, Expected expected) {
  double largest = 0;
  for (int x = 0; x < view.size.width; ++x) {
    const PaperColumn column(map, view, x + 0.5);
    for (int y = 0; y < view.size.height; ++y) {
      largest = std::max(largest, difference(merged(image.at(x, y)), expected(column, y)));
    }
  }
  return largest;
}

// A ray with the azimuth of its column's point in the middle row: it rises as before, and goes over the ground as far
// in that direction as it did; backwards beyond the nadir.
Ray in_column(const View& view, double x, double y) {
  const Ray own = ray_through(view, x, y), middle = ray_through(view, x, view.size.height / 2.0);
  const double share = (own.x * middle.x + own.y * middle.y) / (middle.x * middle.x + middle.y * middle.y);
  return {share * middle.x, share * middle.y, own.z};
}

std::vector<double> pixels_of(double length) {
  std::vector<double> cuts(static_cast<std::size_t>(length) + 1);
  std::iota(cuts.begin(), cuts.end(), 0.0);
  return cuts;
}

}  // namespace

TEST_CASE("points with the paper's choices see what its pseudo-code for a column of pixels sees") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  const auto linear = make_lookup("linear_across");
  for (const char* rays : {"lower_edge", "centre"}) {
    const double down = rays == std::string("centre") ? 0.5 : 1;
    for (const char* coherence : {"none", "resume"}) {
      for (const View& view : paper_views()) {
        CAPTURE(rays, coherence, view.caption);
        const auto frame = terrain.frame(view, all_choices(coherence));
        for (const bool interpolates : {false, true}) {
          CAPTURE(interpolates);
          const Lookup* lookup = interpolates ? linear.get() : nullptr;
          const auto point = sampler("point", {{"rays", std::string(rays)}});
          CHECK(worst(map, view, rendered(*point, *frame, lookup), [&](const PaperColumn& column, int y) {
                  std::map<Element, double> weights;
                  add(weights, column.seen_at(y + down), interpolates, 1);
                  return weights;
                }) <= 1e-6);
          const auto four = sampler("supersample", {{"rays", std::string(rays)}});
          CHECK(worst(map, view, rendered(*four, *frame, lookup), [&](const PaperColumn& column, int y) {
                  std::map<Element, double> weights;
                  for (int k = 0; k < 4; ++k) add(weights, column.seen_at(y + (k + down) / 4), interpolates, 0.25);
                  return weights;
                }) <= 1e-6);
        }
      }
    }
  }
}

// Positions a millionth of a voxel apart may be told apart by rounding where the eye is two million voxels away.
TEST_CASE("area sampling with the paper's choices weighs as its pseudo-code does") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  const auto linear = make_lookup("linear_across");
  const auto area = sampler("area");
  for (const char* coherence : {"none", "resume"}) {
    for (const View& view : paper_views()) {
      CAPTURE(coherence, view.caption);
      const auto frame = terrain.frame(view, all_choices(coherence));
      for (const bool interpolates : {false, true}) {
        const Rendered image = rendered(*area, *frame, interpolates ? linear.get() : nullptr);
        CHECK(worst(map, view, image,
                    [&](const PaperColumn& column, int y) { return area_of_pixel(column, y, interpolates); }) <= 1e-6);
        CHECK(std::all_of(image.pixels.begin(), image.pixels.end(),
                          [](const Content& pixel) { return std::abs(pixel.weight - 1) <= 1e-12; }));
      }
    }
  }
}

TEST_CASE("with the azimuth of their column, points see what a ray turned into that direction sees") {
  const Map map = usual_map();
  for (const double spacing_y : {1.0, 1.7}) {
    const SmallTerrain terrain(map, 1, spacing_y);
    for (View view : views_all_round()) {
      view.spacing_y = spacing_y;
      view.y *= spacing_y;
      CAPTURE(view.caption, spacing_y);
      const auto frame = terrain.frame(view, only("azimuth", "column"));
      const Rendered image = rendered(*sampler("point"), *frame);
      int wrong = 0;
      for (int x = 0; x < view.size.width; ++x) {
        for (int y = 0; y < view.size.height; ++y) {
          const auto expected = seen_by(map, view, in_column(view, x + 0.5, y + 0.5));
          wrong += contains(expected, image.at(x, y).fragments[0].element) ? 0 : 1;
        }
      }
      CHECK(wrong == 0);
    }
  }
}

TEST_CASE("with the azimuth of their column, upright lines see what rays turned into that direction see") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  int runs = 0;
  for (const View& view : views_all_round()) {
    const auto frame = terrain.frame(view, only("azimuth", "column"));
    const int height = view.size.height;
    for (const double x : {0.4, 7.3, view.size.width / 2.0, view.size.width - 0.27}) {
      Tally pieces(static_cast<std::size_t>(height), true);
      const auto cuts = pixels_of(height);
      follow(*frame, {{x, static_cast<double>(height)}, {x, 0}, cuts}, pieces);
      for (int i = 0; i < height; ++i) {
        CAPTURE(view.caption, x, i);
        const auto slot = static_cast<std::size_t>(i);
        CHECK(std::abs(pieces.weight(slot) - 1) <= 1e-12);
        const auto ray_at = [&](double place) { return in_column(view, x, height - place); };
        const auto forward = [&](double place) {
          const Ray ray = ray_at(place), middle = in_column(view, x, height / 2.0);
          return ray.x * middle.x + ray.y * middle.y;
        };
        if (forward(i) * forward(i + 1) <= 1e-12) continue;  // looks both ways: two stretches
        const auto slope = [&](double place) {
          const Ray ray = ray_at(place);
          return ray.z / std::hypot(ray.x, ray.y);
        };
        Verdict verdict;
        judge(map, view, runs_of(pieces, slot, i, i + 1, slope(i) < slope(i + 1)), ray_at, verdict);
        CHECK(verdict.first_wrong == "");
        runs += verdict.runs;
      }
    }
  }
  CHECK(runs > 5'000);
}

TEST_CASE("the azimuth of the column changes nothing in the picture's middle row, nor in its middle column") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  for (View view : paper_views()) {
    view.size = {23, 17};
    CAPTURE(view.caption);
    const Rendered own = rendered(*sampler("point"), *terrain.frame(view, only("azimuth", "pixel")));
    const Rendered column = rendered(*sampler("point"), *terrain.frame(view, only("azimuth", "column")));
    for (int x = 0; x < 23; ++x) CHECK(own.at(x, 8).fragments[0].element == column.at(x, 8).fragments[0].element);
    for (int y = 0; y < 17; ++y) CHECK(own.at(11, y).fragments[0].element == column.at(11, y).fragments[0].element);
  }
}

TEST_CASE("of voxels with near faces alone, points see the first wall that rises above their ray") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  int differ = 0;
  for (const View& view : all_views(map)) {
    CAPTURE(view.caption, view.yaw, view.pitch);
    const Rendered image = rendered(*sampler("point"), *terrain.frame(view, only("face", "near")));
    const Rendered boxes = rendered(*sampler("point"), *terrain.frame(view, only("face", "box")));
    int wrong = 0, on_edges = 0;
    for (int x = 0; x < view.size.width; ++x) {
      for (int y = 0; y < view.size.height; ++y) {
        const Element element = image.at(x, y).fragments[0].element;
        const auto expected = wall_seen_by(map, view, ray_through(view, x + 0.5, y + 0.5));
        wrong += contains(expected, element) ? 0 : 1;
        on_edges += expected.size() > 1 ? 1 : 0;
        differ += element != boxes.at(x, y).fragments[0].element ? 1 : 0;
      }
    }
    CHECK(wrong == 0);
    CHECK(on_edges <= view.on_edges);
  }
  CHECK(differ > 5'000);
}

TEST_CASE("of voxels with near faces alone, upright lines see the walls up to the images of their tops") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  int runs = 0;
  for (const View& view : paper_views()) {
    Changes changes = only("face", "near");
    changes.push_back({"azimuth", std::string("column")});
    const auto frame = terrain.frame(view, changes);
    const int height = view.size.height;
    for (const double x : {0.4, 7.3, view.size.width - 0.27}) {
      Tally pieces(static_cast<std::size_t>(height), true);
      const auto cuts = pixels_of(height);
      follow(*frame, {{x, static_cast<double>(height)}, {x, 0}, cuts}, pieces);
      for (int i = 0; i < height; ++i) {
        CAPTURE(view.caption, x, i);
        Verdict verdict;
        judge(
            map, view, runs_of(pieces, static_cast<std::size_t>(i), i, i + 1, true),
            [&](double place) { return in_column(view, x, height - place); }, verdict, wall_seen_by);
        CHECK(verdict.first_wrong == "");
        runs += verdict.runs;
      }
    }
  }
  CHECK(runs > 500);
}

TEST_CASE(
    "height weights alone divide what the terrain takes up of a stretch by height, and leave the sky its length") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  int stretches = 0, differ = 0;
  std::vector<View> views = paper_views();
  for (View view : paper_views()) {  // and from among the hills
    view.x = 3.3;
    view.y = 5.7;
    view.z = map.height(3, 5) + 0.5;
    views.push_back(view);
  }
  for (const View& view : views) {
    const auto by_area = terrain.frame(view, {{"azimuth", std::string("column")}});
    const auto by_height =
        terrain.frame(view, {{"azimuth", std::string("column")}, {"weights", std::string("height")}});
    const int height = view.size.height;
    for (const double x : {0.4, 7.3, view.size.width - 0.27}) {
      const Ray way = ray_through(view, x, height / 2.0);
      const double ground = std::hypot(way.x, way.y);
      // Over the ground to the edge that ends a voxel: the far one of a top below the eye, else the near one.
      const auto distance = [&](Element element) {
        const TexelIndex at = texel_index(element);
        const auto ends = [&](std::int64_t index, double eye, double per_way) {
          const double a = (static_cast<double>(index) - eye) / per_way;
          const double b = (static_cast<double>(index + 1) - eye) / per_way;
          return std::pair(std::min(a, b), std::max(a, b));
        };
        const auto [east0, east1] = ends(at.i, view.x, way.x / ground);
        const auto [south0, south1] = ends(at.j, view.y, way.y / ground);
        if (map.height(at.i, at.j) < view.z) return std::min({east1, south1, view.far});
        return std::max({east0, south0, 0.0});
      };
      const auto slope = [&](double place) {
        const Ray ray = in_column(view, x, height - place);
        return ray.z / std::hypot(ray.x, ray.y);
      };
      Tally lengths(static_cast<std::size_t>(height), true), heights(static_cast<std::size_t>(height), true);
      const Point from{x, static_cast<double>(height)}, to{x, 0};
      const auto cuts = pixels_of(height);
      follow(*by_area, {from, to, cuts}, lengths);
      follow(*by_height, {from, to, cuts}, heights);
      for (int i = 0; i < height; ++i) {
        CAPTURE(view.caption, x, i);
        const auto slot = static_cast<std::size_t>(i);
        std::map<Element, double> expected, found;
        double rise = 0, length = 0;
        for (const Run& run : runs_of(lengths, slot, i, i + 1, true)) {
          if (run.element == background) {
            expected[background] += run.end - run.begin;
            continue;
          }
          const double part = distance(run.element) * (slope(run.end) - slope(run.begin));
          expected[run.element] += part;
          rise += part;
          length += run.end - run.begin;
        }
        for (auto& [element, weight] : expected) weight *= element == background ? 1 : length / rise;
        heights.for_each(slot, [&](const Fragment& f) { found[f.element] += f.weight; });
        CHECK(difference(expected, found) <= 1e-6);
        CHECK(std::abs(heights.weight(slot) - 1) <= 1e-12);
        std::vector<Element> order, same_order;  // from the stretch's lower end to its upper one
        lengths.for_each(slot, [&](const Fragment& f) { order.push_back(f.element); });
        heights.for_each(slot, [&](const Fragment& f) { same_order.push_back(f.element); });
        CHECK(order == same_order);
        ++stretches;
        std::map<Element, double> by_length;
        lengths.for_each(slot, [&](const Fragment& f) { by_length[f.element] += f.weight; });
        differ += difference(by_length, found) > 1e-3 ? 1 : 0;
      }
    }
  }
  CHECK(differ > stretches / 20);
}

TEST_CASE("with the azimuth of its column, a hit lies under the ray turned into that direction, on top or wall") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  for (const char* face : {"box", "near"}) {
    int tops = 0, hits = 0;
    for (const View& view : paper_views()) {
      if (std::abs(view.x) > 1e5) continue;  // too few digits for places to 1e-8
      Changes changes = only("azimuth", "column");
      changes.push_back({"face", std::string(face)});
      const auto frame = terrain.frame(view, changes);
      for (int x = 0; x < view.size.width; ++x) {
        for (int y = 0; y < view.size.height; ++y) {
          CAPTURE(face, view.caption, x, y);
          const SamplePoint at{x + 0.5, y + 0.5};
          SurfacePoint point;
          Counters counters;
          frame->surface()->locate(std::span(&at, 1), std::span(&point, 1), counters);
          if (!point.textured) continue;
          ++hits;
          const Ray ray = in_column(view, at.x, at.y);
          const double advance = std::hypot(ray.x, ray.y), east = point.s - view.x, south = point.t - view.y;
          REQUIRE(std::abs(east * ray.y - south * ray.x) <= 1e-8 * advance);
          const TexelIndex texel = texel_index(point.hit.element);
          const double ray_height = view.z + ray.z * std::hypot(east, south) / advance;
          const double above = ray_height - map.height(texel.i, texel.j);
          // By a side of the voxel, up to the ray's fall over the 1e-9 that a place is kept away from it, or on its
          // top.
          const bool by_side =
              std::abs(point.s - std::round(point.s)) < 1e-8 || std::abs(point.t - std::round(point.t)) < 1e-8;
          REQUIRE(above <= 1e-7);
          if (!by_side) REQUIRE(std::abs(above) <= 1e-7);
          tops += by_side ? 0 : 1;
        }
      }
    }
    CHECK(hits > 1'000);
    CHECK((face == std::string("near") ? tops == 0 : tops > 300));
  }
}

TEST_CASE("weights sum to 1 with all choices, from awkward places and on radial lines too") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  for (const View& view : awkward_views(map)) {
    CAPTURE(view.caption, view.yaw);
    Changes changes = all_choices();
    changes.push_back({"levels", std::string("round")});
    const auto frame = terrain.frame(view, changes);
    for (const char* layout : {"upright", "radial"}) {
      const Rendered image = rendered(*sampler("area", {{"layout", std::string(layout)}}), *frame);
      CHECK(std::all_of(image.pixels.begin(), image.pixels.end(), [](const Content& pixel) {
        return std::abs(pixel.weight - 1) <= 1e-12 && std::all_of(pixel.fragments.begin(), pixel.fragments.end(),
                                                                  [](const Fragment& f) { return f.weight > 0; });
      }));
    }
  }
}

TEST_CASE("an eye within the ground sees its own voxel with every choice") {
  const Map map = flat_map(4, 4, 5);
  const SmallTerrain terrain(map);
  const View view{.caption = "", .x = 1.3, .y = 2.6, .z = 4, .yaw = 20, .pitch = -10};
  for (const char* name : {"point", "area"}) {
    const Rendered image = rendered(*sampler(name), *terrain.frame(view, all_choices()));
    CHECK(std::all_of(image.pixels.begin(), image.pixels.end(), [](const Content& pixel) {
      return pixel.fragments.size() == 1 && pixel.fragments[0].element == texel_element(0, 1, 2) &&
             std::abs(pixel.fragments[0].weight - 1) <= 1e-12;
    }));
  }
}

}  // namespace moire::test
