// Maps of irradiance, cell by cell held to rays and to areas known on paper.
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include <moire/receivers.h>

#include "hard/kernel.h"
#include "hard/shadow_raster.h"
#include "plugins/shadow_planes/brute_force.h"
#include "plugins/shadow_planes/worlds.h"
#include "sanitized.h"

namespace moire::test {
namespace {

using namespace shadow_planes;

IrradianceMap empty_map(int columns, int rows) {
  return {columns, rows, std::vector<float>(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows))};
}

std::vector<LightPoint> some_lights(int count) {
  Randoms random(8);
  std::vector<LightPoint> lights;
  for (int k = 0; k < count; ++k)
    lights.push_back({static_cast<float>(random(0, 0.999)), static_cast<float>(random(0, 0.999))});
  return lights;
}

// The floor of 6 x 6 seen from above, a pixel a cell: (s, t) of the middles of pixels tell where cells are.
Camera above(int side) {
  Camera camera;
  camera.size = {side, side};
  camera.eye = {0, 0, 100};
  camera.focal = side * 100 / 6.0;
  return camera;
}

// The parts of the cells of a row that are lit.
std::vector<double> lit_row(ShadowRaster& raster, int columns, int j) {
  std::vector<double> lit(static_cast<std::size_t>(columns));
  raster.row(j, [&](int begin, int end, double part) {
    for (int i = begin; i < end; ++i) lit[static_cast<std::size_t>(i)] = part;
  });
  return lit;
}

}  // namespace

TEST_CASE("maps by cell middles have the irradiance that rays find there") {
  constexpr int columns = 37, rows = 23;
  const auto lights = some_lights(sanitized ? 3 : 40);
  for (const char* kind : {"tilted", "parallel", "three", "wall", "slats", "room"}) {
    for (const Shade shade : {Shade::diffuse, Shade::flat}) {
      const World world = built_in_world(shadow_settings({{"kind", std::string(kind)}}));
      const auto frame = frame_of(world, above(50), {shade, Clip::both});
      const LightPoints points(world.light);
      const Receivers& receivers = *frame->receivers();
      // From above all faces of these worlds are seen from the side that is lit; which are the first ones.
      IrradianceMap map = empty_map(columns, rows);
      receivers.add_hard_shadows(0, lights, ShadowEdges::by_middle, map);
      CHECK(std::abs(receivers.extent(0).s - 6) <= 1e-14);
      CHECK(std::abs(receivers.extent(0).t - 6) <= 1e-14);
      // Where the rectangle's corner is and where its sides go.
      const Convex& floor = world.faces[0].parts[0];
      const Vector along = (1.0 / 6) * (floor[1] - floor[0]), down = cross(world.faces[0].plane.normal, along);
      double worst = 0;
      for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
          const Vector p = floor[0] + (6 * (i + 0.5) / columns) * along + (6 * (j + 0.5) / rows) * down;
          double expected = 0;
          for (const LightPoint& light : lights) {
            const Homogeneous there = points.at(static_cast<double>(light.u), static_cast<double>(light.v));
            bool hidden = false;
            for (std::size_t by = 1; by < world.faces.size(); ++by) {
              for (const Convex& part : world.faces[by].parts) hidden = hidden || stands_between(part, p, there);
            }
            const Vector way = Vector{there.x, there.y, there.z} - p;
            const double far = length(way), cosine = way.z / far;
            const double diffuse = points.area() * cosine * cosine / (far * far);  // the light looks straight down
            if (!hidden) expected += (shade == Shade::flat ? 1 : diffuse) / static_cast<double>(lights.size());
          }
          const float found = map.cells[static_cast<std::size_t>(j * columns + i)];
          worst = std::max(worst, std::abs(static_cast<double>(found) - expected));
        }
      }
      CAPTURE(kind, shade == Shade::flat);
      // Forty floats are added, each with an error of some units in the last place of the sum, which is at most 1.
      CHECK(worst <= 40 * 4 * 0x1p-24);
    }
  }
}

TEST_CASE("covered parts of cells are those of the union of shadows, exactly") {
  ShadowRaster raster(4, 3, ShadowEdges::by_area);
  raster.clear();
  raster.add({{0.5, 0.25}, {2.25, 0.25}, {2.25, 1.5}, {0.5, 1.5}});
  raster.add({{0.5, 0.25}, {2.25, 0.25}, {2.25, 1.5}, {0.5, 1.5}});  // once more
  raster.add({{2, 1}, {4, 1}, {4, 2}, {2, 2}});                      // overlaps a corner, reaches the border
  raster.sort();
  CHECK(lit_row(raster, 4, 0) == std::vector<double>{1 - 0.375, 0.25, 1 - 0.1875, 1});
  CHECK(lit_row(raster, 4, 1) == std::vector<double>{0.75, 0.5, 0, 0});
  CHECK(lit_row(raster, 4, 2) == std::vector<double>{1, 1, 1, 1});
  // A row may be asked for again.
  CHECK(lit_row(raster, 4, 1) == std::vector<double>{0.75, 0.5, 0, 0});
}

TEST_CASE("covered parts of slanted shadows that overlap sum to what many points find") {
  constexpr int columns = 9, rows = 7, fine = sanitized ? 16 : 128;
  Randoms random(4);
  for (int k = 0; k < (sanitized ? 5 : 40); ++k) {
    ShadowRaster area(columns, rows, ShadowEdges::by_area);
    ShadowRaster middles(columns * fine, rows * fine, ShadowEdges::by_middle);
    area.clear(), middles.clear();
    const int count = 1 + k % 4;
    for (int s = 0; s < count; ++s) {
      Outline triangle;
      while (triangle.empty() || doubled_area(triangle) <= 0) {
        triangle.clear();
        for (int i = 0; i < 3; ++i) triangle.push_back({random(0, columns), random(0, rows)});
      }
      area.add(triangle);
      for (Point& p : triangle) p = {p.x * fine, p.y * fine};
      middles.add(triangle);
    }
    area.sort(), middles.sort();
    for (int j = 0; j < rows; ++j) {
      const auto lit = lit_row(area, columns, j);
      std::vector<double> many(columns);
      for (int i = 0; i < fine; ++i) {
        const auto row = lit_row(middles, columns * fine, j * fine + i);
        for (std::size_t x = 0; x < row.size(); ++x) many[x / fine] += row[x] / (1.0 * fine * fine);
      }
      // Three edges a triangle, each through 2 fine points of a cell at most, wrong by half a point each.
      for (std::size_t i = 0; i < many.size(); ++i) CHECK(std::abs(lit[i] - many[i]) <= 3.0 * count / fine);
    }
  }
}

TEST_CASE("a cell gets the same bits in runs of any length, and so in vectors of any width") {
  const KernelRow row{-1.7F, 0.013F, 3.1F, 0.4F, -0.21F};
  constexpr int count = 300;
  std::vector<float> whole(count, 0.1F), single(count, 0.1F), broken(count, 0.1F);
  add_kernel(row, 0, count, 0.7F, whole.data());
  for (int i = 0; i < count; ++i) add_kernel(row, i, i + 1, 0.7F, single.data());
  for (int i = 0, length = 1; i < count; i += length, ++length)
    add_kernel(row, i, std::min(count, i + length), 0.7F, broken.data());
  CHECK(whole == single);
  CHECK(whole == broken);
  // Part of it is behind the light.
  CHECK(whole.front() > 0.1F);
  CHECK(whole.back() == 0.1F);
}

TEST_CASE("coplanar duplicates and lights in several calls leave maps as they are") {
  World world = built_in_world(shadow_settings({{"kind", std::string("three")}}));
  const auto lights = some_lights(20);
  const auto map_of = [&](ShadowEdges edges) {
    const auto frame = frame_of(world, above(50));
    IrradianceMap map = empty_map(31, 29);
    frame->receivers()->add_hard_shadows(0, lights, edges, map);
    return map.cells;
  };
  for (const ShadowEdges edges : {ShadowEdges::by_area, ShadowEdges::by_middle}) {
    const auto cells = map_of(edges);
    const Face copy = world.faces[2];
    world.faces.push_back(copy);
    CHECK(map_of(edges) == cells);
    world.faces.pop_back();
  }
  const auto frame = frame_of(world, above(50));
  IrradianceMap one = empty_map(31, 29), two = empty_map(31, 29);
  frame->receivers()->add_hard_shadows(0, lights, ShadowEdges::by_area, one);
  frame->receivers()->add_hard_shadows(0, std::span(lights).first(10), ShadowEdges::by_area, two);
  frame->receivers()->add_hard_shadows(0, std::span(lights).last(10), ShadowEdges::by_area, two);
  for (std::size_t k = 0; k < one.cells.size(); ++k) CHECK(std::abs(one.cells[k] - two.cells[k] / 2) <= 20 * 0x1p-24F);
}

TEST_CASE("places on receivers and what they show agree with what points see where all is lit") {
  World world = built_in_world(shadow_settings());
  for (Face& face : world.faces) face.casts = false;
  for (const Shade shade : {Shade::diffuse, Shade::flat}) {
    const auto frame = frame_of(world, camera_of(shadow_settings(), {64, 48}), {shade, Clip::both});
    const Receivers& receivers = *frame->receivers();
    const LightPoint light{0.3F, 0.8F};
    // On a fine map the cell's middle is near.
    constexpr int side = 800;
    std::vector<IrradianceMap> maps(receivers.count(), empty_map(side, side));
    for (std::uint32_t k = 0; k < receivers.count(); ++k)
      receivers.add_hard_shadows(k, {&light, 1}, ShadowEdges::by_area, maps[k]);
    Randoms random(2);
    int on_receivers = 0;
    for (int k = 0; k < 500; ++k) {
      const SamplePoint p{random(0, 64), random(0, 48), light.u, light.v};
      const Hit expected = hit_at(*frame, p);
      ReceiverPoint place;
      Counters counters;
      receivers.locate({&p, 1}, {&place, 1}, counters);
      Hit hit = place.hit;
      if (place.receiver != ReceiverPoint::none) {
        ++on_receivers;
        CHECK((place.s >= 0 && place.s <= 1 && place.t >= 0 && place.t <= 1));
        const auto i = std::min(side - 1, static_cast<int>(place.s * side));
        const auto j = std::min(side - 1, static_cast<int>(place.t * side));
        hit = receivers.shaded(place.receiver,
                               static_cast<double>(maps[place.receiver].cells[static_cast<std::size_t>(j * side + i)]));
      }
      const float off = std::max({std::abs(hit.color.r - expected.color.r), std::abs(hit.color.g - expected.color.g),
                                  std::abs(hit.color.b - expected.color.b)});
      CHECK(off <= 0.01F);
      // What that point of the light does not reach others do.
      if (static_cast<std::uint32_t>(expected.element) == 0) CHECK(hit.element == expected.element);
    }
    CHECK(on_receivers > 200);
  }
}

}  // namespace moire::test
