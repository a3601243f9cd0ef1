// Fields, hedges, farm tracks and villages.
#include "farmland.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "palette.h"

namespace heightfield {
namespace {

constexpr double plot_side = 58, farthest_border = 4;  // voxels

// The nearest of scattered sites owns a place (Worley 1996, doi:10.1145/237170.237267).
Plot plot_at(const Noise& noise, Vector voxel) {
  const Vector p = (1 / plot_side) * voxel;
  const auto ix = static_cast<int>(std::floor(p.x)), iy = static_cast<int>(std::floor(p.y));
  std::array<Vector, 25> sites;
  std::array<std::uint64_t, 25> hashes;
  std::size_t nearest = 0, count = 0;
  double best = 1e9;
  for (int j = -2; j <= 2; ++j)
    for (int i = -2; i <= 2; ++i, ++count) {
      const std::uint64_t hash = hashes[count] = hashed(noise.key(), ix + i, iy + j);
      sites[count] = Vector{ix + i + 0.1 + 0.8 * part(hash, 0), iy + j + 0.1 + 0.8 * part(hash, 16)} - p;
      const double squared = dot(sites[count], sites[count]);
      if (squared >= best) continue;
      best = squared;
      nearest = count;
    }
  // A border lies half way between two sites, so sites much farther than the nearest one have none near enough.
  double border = farthest_border / plot_side;
  const double reach = std::sqrt(best) + 2 * border;
  for (std::size_t k = 0; k < count; ++k) {
    if (k == nearest || dot(sites[k], sites[k]) > reach * reach) continue;
    const Vector between = sites[k] - sites[nearest];
    border = std::min(border, dot(0.5 * (sites[k] + sites[nearest]), between) / length(between));
  }
  return {moire::mixed(hashes[nearest]), voxel + plot_side * sites[nearest], -plot_side * sites[nearest],
          plot_side * border};
}

// 0 .. 1 .. 0 once a period.
double wave(double position, double period) {
  const double t = position / period - std::floor(position / period);
  return t < 0.5 ? 2 * t : 2 - 2 * t;
}

Cover rows(double across, double period, moire::Color between, moire::Color row, double height) {
  const double part_of_row = ramp(0.35, 0.65, wave(across, period));
  return {mix(between, row, part_of_row), height * part_of_row};
}

// Rows of bushes with a step of `spacing` along them.
Cover bushes(double along, double across, double spacing, moire::Color between, moire::Color bush, double height) {
  const double u = 2 * wave(along, spacing) - 1, v = 2 * wave(across, spacing) - 1;
  const double crown = ramp(0.9, 0.2, length({1 - u, 1 - v}) / 1.4);
  return {mix(between, bush, crown), height * crown};
}

// Wheat with the lines in which tractors drive.
Cover wheat(double across) {
  const double line = across - 11 * std::floor(across / 11);
  if (line < 1 || (line > 2.5 && line < 3.5)) return {palette::stubble, 0};
  return {mix(palette::wheat, palette::stubble, 0.35 * wave(across, 2.6)), 0.6};
}

Cover grown(std::uint64_t hash, double along, double across) {
  const double fine = 2.6 + 1.8 * part(hash, 40);
  switch (hash % 16) {
    case 0:
    case 9:
      return rows(across, fine, palette::furrow, palette::soil, 0.3);
    case 1:
    case 10:
      return rows(across, fine + 0.6, palette::soil, palette::crop, 0.5);
    case 2:
      return rows(across, 3.2, palette::rapeseed_row, palette::rapeseed, 0.7);
    case 3:
      return rows(across, 9, palette::mown, palette::hay, 0.1);
    case 4:
      return rows(across, 3.6, palette::soil, palette::lavender, 0.6);
    case 5:
      return bushes(along, across, 5, palette::meadow, palette::vine, 1.5);
    case 6:
      return rows(across, fine, palette::stubble, palette::wheat, 0.2);
    case 7:
      return rows(across, fine, palette::furrow, palette::crop, 0.4);
    case 8:
      return rows(across, 7, palette::mown, palette::meadow, 0.1);
    default:
      return wheat(across);
  }
}

Cover house(std::uint64_t hash, double along, double across) {
  const double half_length = 2 + 1.2 * part(hash, 8), half_width = 1.6 + 0.5 * part(hash, 24);
  if (std::abs(along) > half_length || std::abs(across) > half_width) return {palette::yard, 0};
  const moire::Color roof = mix(palette::roof, palette::old_roof, part(hash, 36));
  return {roof, 3.2 - 1.4 * std::abs(across) / half_width};
}

// Houses on lots along streets, some lots gardens.
Cover village(std::uint64_t key, double along, double across) {
  constexpr double lot = 8.5;
  const double i = std::floor(along / lot), j = std::floor(across / lot);
  const double u = along - (i + 0.5) * lot, v = across - (j + 0.5) * lot;
  const std::uint64_t hash = hashed(key, static_cast<std::int64_t>(i), static_cast<std::int64_t>(j));
  if (std::abs(v) > 3.4) return {palette::road, 0};
  if (part(hash, 0) < 0.62) return house(hash, u + 2 * part(hash, 30) - 1, v);
  return bushes(u + 2, v + 2, 4, palette::mown, palette::beech, 2.5);
}

}  // namespace

// A row of bushes and trees with gaps; `into` is the distance from its middle.
Cover Farmland::hedge(Vector voxel, double into) const {
  const double growth = bend_(0.11 * voxel) + 0.8 * grain_.white(static_cast<int>(voxel.x), static_cast<int>(voxel.y));
  const double height = 2.4 * growth * ramp(2.2, 0.4, into);
  return {mix(palette::hedge, palette::beech, 0.5 * growth), std::clamp(height, 0.2, 2.6)};
}

Plot Farmland::plot(Vector voxel) const {
  const NoiseValue bend = bend_.at(0.009 * voxel);
  return plot_at(plots_, voxel + 5.0 * Vector{bend.gradient.y, bend.gradient.x});
}

Cover Farmland::at(Vector voxel, const Plot& plot) const {
  const bool tracked = (plot.hash >> 50) % 3 == 0;
  if (plot.border < 1.1) return {palette::track, 0};
  if (plot.border < 3.4 && !tracked) return hedge(voxel, std::abs(plot.border - 2.2));

  const Vector lie = direction(plot.hash);
  const double along = dot(lie, plot.from_site), across = lie.x * plot.from_site.y - lie.y * plot.from_site.x;
  if (part(plot.hash, 20) < 0.07) return village(plot.hash, along, across);

  // A plot is one field or cut into strips; a line of grass divides them.
  const double strip = 13 + 30 * part(plot.hash, 30), number = std::floor(across / strip);
  if (across - number * strip < 1.1) return {palette::verge, 0.3};
  return grown(hashed(plot.hash, static_cast<std::int64_t>(number), 1), along, across);
}

}  // namespace heightfield
