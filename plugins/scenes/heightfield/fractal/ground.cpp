// The bare ground of the fractal terrain.
#include "ground.h"

#include <algorithm>
#include <cmath>

#include "drainage.h"
#include "noise.h"

namespace heightfield {
namespace {

// Where things lie on the unit square, y from the mountains to the plains.
class Layout {
 public:
  explicit Layout(std::uint64_t seed)
      : bends_(seed, 1), coast_(seed, 2), massif_(seed, 3), lake_x_(0.35 + 0.3 * part(moire::mixed(seed + 5), 0)) {}

  // The layout changes slowly: a coarse grid holds it.
  Uplands uplands() const {
    constexpr int side = 256;
    Uplands result{{side, side}, {side, side}};
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const Vector p = {(x + 0.5) / side, (y + 0.5) / side};
        result.shore.at(x, y) = 2 * shore(p);
        result.steepness.at(x, y) = steepness(p);
      }
    return result;
  }

 private:
  // Distance to the shore as part of the map's side, below 0 on water.
  double shore(Vector p) const {
    const Vector q = p + 0.03 * Vector{coast_.sum(5.0 * p, 3), coast_.sum(5.0 * p + Vector{40, 7}, 3)};
    const double run = (river_y(q.x + 0.005) - river_y(q.x - 0.005)) / 0.01;
    const double river =
        std::abs(q.y - river_y(q.x)) / std::sqrt(1 + run * run) - 0.01 - 0.004 * bends_({9 * q.x, 3.5});
    const Vector from_lake = {(q.x - lake_x_) / 1.7, q.y - river_y(lake_x_)};
    const double lake = length(from_lake) - 0.075 + 0.055 * coast_.sum(7.0 * p + Vector{3, 3}, 4);
    // A lake among the mountains, cut by the map's edge, so that the crests do not all run to it.
    const Vector from_tarn = {(p.x - 1 + lake_x_) / 1.3, p.y - 0.01};
    const double tarn = length(from_tarn) - 0.05 + 0.04 * coast_.sum(9.0 * p + Vector{8, 1}, 3);
    return std::min({river, lake, tarn});
  }

  double steepness(Vector p) const {
    const double inland = river_y(p.x) - p.y + 0.07 * massif_.sum(4.0 * p, 3);
    const double mountains = ramp(0.02, 0.26, inland) * (0.2 + 1.1 * massif_.ridges(3.0 * p + Vector{9, 1}, 3));
    const double hills = ramp(0.1, 0.36, -inland) * ramp(-0.25, 0.5, massif_.sum(3.5 * p + Vector{2, 30}, 2));
    return 0.03 + mountains + 0.4 * hills;
  }

  double river_y(double x) const {
    // Level where it leaves the map, so that it goes on without a corner where the map is mirrored.
    const double t = ramp(0, 1, x);
    return 0.46 + 0.16 * bends_({2.3 * t, 0.5}) + 0.06 * bends_({7 * t, 9.5});
  }

  Noise bends_, coast_, massif_;
  double lake_x_;
};

// What the voxels see of the drainage: its heights and streams, on a map bent a little so that its eight directions
// do not show.
class Watershed {
 public:
  Watershed(int size, std::uint64_t seed)
      : drainage_(drain(std::max(4, size / 2), Layout(seed).uplands(), Noise(seed, 4))) {}

  Vector place(Vector p) const { return static_cast<double>(drainage_.height.width) * p - Vector{0.5, 0.5}; }
  double height(Vector place) const { return smooth_value(drainage_.height, place.x, place.y); }

  // Streams run along the sides and diagonals of the squares between four nodes.
  double stream(Vector place) const {
    const int x = static_cast<int>(std::floor(place.x)), y = static_cast<int>(std::floor(place.y));
    double strength = 0;
    for (int k = 0; k < 4; ++k) {
      const int i = std::clamp(x + k % 2, 0, drainage_.height.width - 1);
      const int j = std::clamp(y + k / 2, 0, drainage_.height.height - 1);
      const double catchment = drainage_.catchment.at(i, j);
      if (catchment > 0.004) strength = std::max(strength, along(place, i, j, 0.1 + 2 * std::sqrt(catchment)));
    }
    return strength;
  }

 private:
  // 1 within `half_width` of the line from node (i, j) to its receiver, falling to 0 over half a node.
  double along(Vector place, int i, int j, double half_width) const {
    const int receiver = drainage_.receiver.at(i, j);
    const Vector from = {static_cast<double>(i), static_cast<double>(j)};
    const Vector run = Vector{static_cast<double>(receiver % drainage_.height.width),
                              static_cast<double>(receiver / drainage_.height.width)} -
                       from;
    const double squared = dot(run, run);
    if (squared == 0) return 0;
    const double t = std::clamp(dot(place - from, run) / squared, 0.0, 1.0);
    return ramp(half_width + 0.35, half_width, length(place - from - t * run));
  }

  Drainage drainage_;
};

}  // namespace

Ground raise_ground(int size, std::uint64_t seed, double relief) {
  const Watershed watershed(size, seed);
  const Noise bend(seed, 5), crags(seed, 6), swells(seed, 7);
  const double scale = std::min(relief, 100.0) / 100;  // of what is as wide in voxels on every map
  Ground ground{relief, {size, size}, {size, size}};
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const Vector voxel = {x + 0.5, y + 0.5};
      const NoiseValue wide = bend.at(0.04 * voxel), narrow = bend.at(0.13 * voxel);
      const Vector bent =
          voxel + 5.0 * Vector{wide.value, wide.gradient.x * 0.5} + 1.5 * Vector{narrow.gradient.y * 0.5, narrow.value};
      const Vector place = watershed.place((1.0 / size) * bent);
      const double base = relief * watershed.height(place);
      // Crags on the mountains, gentle swells on the plains; both vanish at the shore.
      const double altitude = ramp(0.04, 0.3, base / relief);
      double height = base;
      if (altitude > 0) height += scale * altitude * 9 * (crags.ridges(0.03 * voxel, 4) - 0.35);
      if (altitude < 1) height += scale * (1 - altitude) * ramp(0, 3, base) * (0.8 + 2 * swells.sum(0.012 * voxel, 2));
      ground.height.at(x, y) = std::min(height, relief);
      ground.stream.at(x, y) = base > 0 ? static_cast<float>(watershed.stream(place)) : 0.0F;
    }
  return ground;
}

}  // namespace heightfield
