// Summits of blocks, held to all voxels of the blocks; and walks that pass over what they hide, held to walks that look
// at every voxel: the same bits.
#include "summits.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>

#include <moire/random.h>

#include "plugins/heightfield/views.h"
#include "voxels.h"

namespace moire::test {
namespace {

using heightfield::Summits;

// The highest voxel in all blocks that a run touches.
float highest_by_brute_force(const Map& map, const Summits::Run& run) {
  const int period_p = 2 * (run.swapped ? map.rows : map.columns),
            period_q = 2 * (run.swapped ? map.columns : map.rows);
  const auto begin = [](int index) { return index - index % Summits::block; };
  const auto end = [&](int index, int period) { return std::min(begin(index) + Summits::block, period); };
  float highest = -1;
  for (int k = 0; k <= run.aside; ++k) {
    const int q = (run.q + k) % period_q;
    for (int i = begin(run.p); i < end(run.p, period_p); ++i) {
      for (int j = begin(q); j < end(q, period_q); ++j) {
        highest = std::max(highest, run.swapped ? map.height(j, i) : map.height(i, j));
      }
    }
  }
  return highest;
}

// Grazing over rough ground, where most is hidden, and steeper.
std::vector<View> grazing_views() {
  std::vector<View> views;
  for (const double yaw : {0.0, 17.0, 45.0, 101.0, 200.0, 290.0}) {
    for (const double pitch : {-3.0, -10.0, -35.0}) {
      View view{.caption = "grazing", .x = 3.3, .y = 5.7, .z = 13, .yaw = yaw, .pitch = pitch, .fov = 30, .far = 900};
      view.size = {19, 29};
      views.push_back(view);
    }
  }
  return views;
}

}  // namespace

TEST_CASE("the summit of a run's blocks is the highest of their voxels") {
  for (const auto& [columns, rows] : {std::pair{16, 16}, {1, 7}, {40, 24}, {19, 50}}) {
    const Map map = rough_map(columns, rows, 100);
    std::vector<heightfield::Cell> cells;
    for (const float height : map.heights) cells.push_back({height, {0, 0, 0}});
    const Summits summits(cells, columns, rows);
    for (int k = 0; k < 500; ++k) {
      const auto below = [&](int limit, int dimension) {
        return static_cast<int>(limit * random({.x = k}, 0, dimension));
      };
      const bool swapped = k % 2 == 1;
      const Summits::Run run{swapped, below(2 * (swapped ? rows : columns), 0),
                             below(2 * (swapped ? columns : rows), 1), below(40, 2)};
      CAPTURE(columns, rows, run.swapped, run.p, run.q, run.aside);
      CHECK(summits.highest(run) == highest_by_brute_force(map, run));
      const int period = 2 * (swapped ? rows : columns), length = summits.length(swapped, run.p);
      CHECK(length > 0);
      CHECK((run.p + length - 1) / Summits::block == run.p / Summits::block);
      CHECK((run.p + length == period || (run.p + length) % Summits::block == 0));
    }
  }
}

TEST_CASE("passing over hidden voxels changes neither a bit nor a count") {
  std::uint64_t hits = 0, steps = 0;
  for (const Map& map : {rough_map(64, 64, 12), rough_map(40, 24, 12, 5), flat_map(48, 16), rough_map(1, 64, 12)}) {
    const SmallTerrain terrain(map);
    std::vector<View> views = grazing_views();
    for (const char* walk : {"major", "grid"}) {
      for (const char* levels : {"none", "floor"}) {
        for (const View& view : views) {
          for (const char* name : {"point", "area"}) {
            for (const bool recording : {false, true}) {
              CAPTURE(map.columns, map.rows, walk, levels, view.yaw, view.pitch, name, recording);
              const auto as = [&](const char* skip) {
                const auto frame = terrain.frame(
                    view, {{"walk", std::string(walk)}, {"levels", std::string(levels)}, {"skip", std::string(skip)}});
                return rendered(*sampler(name), *frame, nullptr, {.recording = recording});
              };
              const Rendered every = as("off");
              hits += every.counters.hits;
              steps += every.counters.steps;
              for (const char* skip : {"on", "auto"}) {
                const Rendered some = as(skip);
                CHECK(first_difference(some, every) == "");
                CHECK(some.counters == every.counters);
              }
            }
          }
        }
      }
    }
  }
  CHECK(hits < steps / 2);  // much is hidden
}

}  // namespace moire::test
