// Area sampling on one upright line a pixel is the paper's AS: all and only the voxels that are visible on that line.
// Held to the metric `coverage` against the column, and to 64 single rays a pixel in the vertical plane of its middle.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <map>
#include <set>

#include "metrics/registry.h"
#include "plugins/heightfield/brute_force.h"
#include "plugins/heightfield/views.h"
#include "run/column_line.h"

namespace moire::test {
namespace {

std::map<std::string, double> column_coverage(const Sampler& sampler, const Frame& frame) {
  Settings settings(coverage_description.parameters);
  settings.set("against", std::string("column"));
  const auto metric = make_coverage(settings);
  const ImageSize size = frame.size();
  metric->begin(size);

  const Workers workers(1);
  std::vector<MergedBlock> exact;
  workers.render(ColumnLine(frame), frame, true,
                 [&](std::size_t, const PixelBlock& block) { exact.emplace_back(block); });
  Picture picture{size, std::vector<Color>(static_cast<std::size_t>(size.width * size.height))};
  Counters counters;
  workers.render(*sampler.begin({.frame = frame}), frame, true, [&](std::size_t index, const PixelBlock& block) {
    metric->block(block, exact[index]);
    counters += block.counters;
  });
  std::map<std::string, double> values;
  for (const Measurement& m : metric->finish({picture, picture, counters})) values[std::string(m.quantity)] = m.value;
  return values;
}

// Views whose pictures have no nadir or zenith in them: there no column lies in one direction from the camera.
std::vector<View> plain_views() {
  std::vector<View> views = views_all_round();
  std::erase_if(views, [](const View& view) { return view.pitch < -50; });
  return views;
}

// The ray of a place in a pixel, moved sideways into the vertical plane of the pixel's middle: it keeps its height and
// its advance along the axis along which the middle advances more voxels.
Ray in_plane_of(const View& view, Ray ray, Ray middle) {
  if (std::abs(middle.y / view.spacing_y) > std::abs(middle.x / view.spacing_x)) {
    return {ray.y * middle.x / middle.y, ray.y, ray.z};
  }
  return {ray.x, ray.x * middle.y / middle.x, ray.z};
}

// The elements that rays at these many equally spaced places of a pixel's middle line see.
std::set<Element> seen_in(const Map& map, const View& view, int x, int y, int places) {
  const Ray middle = ray_through(view, x + 0.5, y + 0.5);
  std::set<Element> seen;
  for (int k = 0; k < places; ++k) {
    const Ray ray = in_plane_of(view, ray_through(view, x + 0.5, y + (k + 0.5) / places), middle);
    const std::vector<Element> elements = seen_by(map, view, ray);
    if (elements.size() == 1) seen.insert(elements.front());
  }
  return seen;
}

}  // namespace

TEST_CASE("against the column, area sampling sees all and only the visible voxels") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  for (const char* walk : {"grid", "major"}) {
    for (const char* levels : {"none", "floor"}) {
      for (const View& view : plain_views()) {
        CAPTURE(view.caption, walk, levels);
        const auto frame = terrain.frame(view, {{"walk", std::string(walk)}, {"levels", std::string(levels)}});
        const auto values = column_coverage(*sampler("area"), *frame);
        if (values.at("coverage.visible") == 0) continue;
        CHECK(values.at("coverage.ratio") == 1);
        CHECK(values.at("coverage.leak") == 0);
        CHECK(values.at("coverage.weight_error") == 0);
      }
    }
  }
}

TEST_CASE("against the column, points see less the fewer they are, and nothing that is hidden") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  const View view{.caption = "", .x = 3.3, .y = 5.7, .z = 9, .yaw = 20, .pitch = -12, .size = {45, 40}};
  const auto frame = terrain.frame(view);
  double last = 0;
  for (const std::int64_t n : {1, 2, 4, 8, 16, 32}) {
    const auto values = column_coverage(*sampler("supersample", {{"n", n}}), *frame);
    CHECK(values.at("coverage.ratio") > last);
    last = values.at("coverage.ratio");
    CHECK(last <= 1);
  }
  CHECK(last > 0.9);
}

TEST_CASE("with the azimuth of the column, points on it see nothing that the column does not") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  const auto points = sampler("supersample", {{"n", std::int64_t{8}}});
  int leaks_without = 0;
  for (const View& view : plain_views()) {
    const auto leak = [&](const char* azimuth, const char* face) {
      const auto values = column_coverage(
          *points, *terrain.frame(view, {{"azimuth", std::string(azimuth)}, {"face", std::string(face)}}));
      return values.at("coverage.visible") == 0 ? 0 : values.at("coverage.leak");
    };
    CAPTURE(view.caption);
    CHECK(leak("column", "box") <= 1e-12);
    CHECK(leak("column", "near") <= 1e-12);
    leaks_without += leak("pixel", "box") > 1e-3 ? 1 : 0;
  }
  CHECK(leaks_without > 10);
}

TEST_CASE("area sampling on a column finds what 64 rays a pixel see, and they find all of its larger fragments") {
  constexpr int places = 64;
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  int fragments = 0;
  for (const View& view : plain_views()) {
    const auto frame = terrain.frame(view, {{"coherence", std::string("none")}});
    const Rendered image = rendered(*sampler("area"), *frame);
    for (const int x : {0, view.size.width / 3, view.size.width - 1}) {
      for (int y = 0; y < view.size.height; ++y) {
        CAPTURE(view.caption, x, y);
        const std::set<Element> seen = seen_in(map, view, x, y, places);
        std::map<Element, double> own;
        for (const Fragment& fragment : image.at(x, y).fragments) own[fragment.element] += fragment.weight;
        fragments += static_cast<int>(own.size());
        CHECK(std::all_of(seen.begin(), seen.end(), [&](Element element) { return own.contains(element); }));
        CHECK(std::all_of(own.begin(), own.end(), [&](const auto& entry) {
          return entry.second <= 2.0 / places || seen.contains(entry.first);
        }));
      }
    }
  }
  CHECK(fragments > 2000);
}

}  // namespace moire::test
