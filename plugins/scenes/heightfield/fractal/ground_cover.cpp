// What covers the ground of the fractal terrain.
#include "ground_cover.h"

#include <cmath>
#include <optional>

#include "farmland.h"
#include "palette.h"
#include "woodland.h"

namespace heightfield {
namespace {

// The ground under one voxel.
struct Site {
  int x, y;
  Vector voxel;
  double height, altitude, slope, stream;  // altitude: height as part of the relief
};

class Painter {
 public:
  Painter(const Ground& ground, std::uint64_t seed)
      : ground_(ground),
        farmland_(seed),
        woodland_(seed),
        broad_(seed, 10),
        woods_(seed, 11),
        fine_(seed, 12),
        roads_(seed, 13),
        grain_(seed, 14) {}

  Cover cover(int x, int y) const {
    const Site site = site_at(x, y);
    const Cover cover = site.height < 0 ? water(site) : land(site);
    return {scaled(cover.color, 0.86 + 0.28 * grain_.white(x, y)), cover.height};
  }

 private:
  Site site_at(int x, int y) const {
    const Grid<double>& h = ground_.height;
    const Vector slope = 0.5 * Vector{h.near(x + 1, y) - h.near(x - 1, y), h.near(x, y + 1) - h.near(x, y - 1)};
    return {x, y, {x + 0.5, y + 0.5}, h.at(x, y), h.at(x, y) / ground_.relief, length(slope), ground_.stream.at(x, y)};
  }

  // Ripples lie across the wind.
  Cover water(const Site& site) const {
    const moire::Color body = mix(palette::shallow, palette::deep, ramp(0, 6, -site.height));
    const double ripple = fine_({0.11 * site.voxel.x, 0.42 * site.voxel.y});
    return with_road(site, {scaled(body, 1 + 0.5 * ripple)});
  }

  Cover land(const Site& site) const {
    if (site.height < 0.25 + 0.3 * fine_(0.06 * site.voxel) && site.slope < 0.35)
      return {mix(palette::wet_sand, palette::sand, ramp(0, 0.2, site.height))};
    const double broad = broad_.sum(0.009 * site.voxel, 2);
    const std::optional<Cover> tilled = field(site, broad);
    Cover cover = tilled ? *tilled : wooded(site, broad, mountainside(site, broad));
    if (site.stream > 0) cover = {mix(cover.color, palette::stream, site.stream), cover.height * (1 - site.stream)};
    return with_road(site, cover);
  }

  std::optional<Cover> field(const Site& site, double broad) const {
    if (broad > 0.3 || site.slope > 0.5 || site.altitude > 0.2) return std::nullopt;
    const Plot plot = farmland_.plot(site.voxel);
    if (!invites_farming(plot)) return std::nullopt;
    return farmland_.at(site.voxel, plot);
  }

  // Low and nearly level all over the plot.
  bool invites_farming(const Plot& plot) const {
    constexpr int reach = 14;
    const int x = static_cast<int>(plot.site.x), y = static_cast<int>(plot.site.y);
    const Grid<double>& h = ground_.height;
    const double fall =
        std::abs(h.near(x + reach, y) - h.near(x - reach, y)) + std::abs(h.near(x, y + reach) - h.near(x, y - reach));
    return fall < 5 && h.near(x, y) < 0.17 * ground_.relief;
  }

  // Grass, scree, rock in layers, snow.
  Cover mountainside(const Site& site, double broad) const {
    const double fine = fine_.sum(0.14 * site.voxel, 2);
    const moire::Color low = mix(palette::meadow, palette::dry_grass, ramp(-0.3, 0.5, broad + 0.5 * fine));
    const moire::Color grass = mix(low, palette::alpine, ramp(0.2, 0.45, site.altitude));
    const double bare = ramp(0.75, 1.05, site.slope + 0.3 * fine + 0.5 * (site.altitude - 0.4));
    const moire::Color ground = bare > 0 ? mix(grass, rock(site, fine), bare) : grass;
    const double snow = ramp(0.37, 0.42, site.altitude + 0.12 * broad + 0.14 * fine - 0.2 * site.slope);
    return {mix(ground, palette::snow, snow)};
  }

  moire::Color rock(const Site& site, double fine) const {
    const double layer = 0.12 * site.height + 0.012 * site.voxel.x + 1.5 * broad_(0.02 * site.voxel) + 0.2 * fine;
    const double in_layer = layer - std::floor(layer);
    const moire::Color stone =
        mix(palette::granite, palette::ochre, part(hashed(grain_.key(), static_cast<int>(std::floor(layer)), 0), 0));
    return mix(palette::slate, stone, ramp(0.05, 0.3, in_layer));
  }

  Cover wooded(const Site& site, double broad, const Cover& open) const {
    constexpr double treeline = 0.5;
    if (site.altitude > treeline) return open;
    const double belt = ramp(0.05, 0.16, site.altitude) * ramp(0.52, 0.36, site.altitude);
    const double wish = woods_.sum(0.016 * site.voxel, 3) + 0.55 * belt - 0.12 + 0.3 * ramp(0.2, 0.5, broad);
    const double density =
        0.95 * ramp(0, 0.22, wish - 0.45 * ramp(0.7, 1.2, site.slope)) * ramp(treeline, 0.42, site.altitude) +
        0.015 * ramp(0.3, 0.2, site.altitude);
    if (density <= 0) return open;
    const Cover floor = {mix(open.color, palette::forest_floor, 0.8 * ramp(0.2, 0.7, density)), open.height};
    return woodland_.at(site.voxel, density, ramp(0.08, 0.34, site.altitude), floor);
  }

  // Roads follow the level lines of a noise, whose gradient gives their width in voxels; they cross narrow water on
  // bridges, and climb high as footpaths.
  Cover with_road(const Site& site, const Cover& cover) const {
    if (site.slope > 0.7 || site.altitude > 0.6) return cover;
    constexpr double scale = 0.0052;
    const NoiseValue wide = roads_.at(scale * site.voxel), winding = roads_.at(3.1 * scale * site.voxel + Vector{7, 7});
    const double value = wide.value + 0.16 * winding.value;
    const Vector slope = scale * (wide.gradient + 0.16 * 3.1 * winding.gradient);
    const double from_road = std::abs(value) / (length(slope) + 1e-9);
    if (site.height < 0) {
      if (from_road < 1.5 && is_narrow(site, {-slope.y, slope.x})) return {palette::road, 1.2};
    } else if (site.altitude < 0.24) {
      if (from_road < 1.5) return {palette::road};
      if (from_road < 2.6) return {palette::verge, 0.2};
    } else if (from_road < 0.7) {
      return {palette::track};
    }
    return cover;
  }

  // True if a bridge along `road` would soon reach land at both its ends.
  bool is_narrow(const Site& site, Vector road) const {
    constexpr double longest = 40;
    const Vector step = (1 / (length(road) + 1e-9)) * road;
    double span = 0;
    for (const double side : {-1.0, 1.0})
      for (double from = 0; span < longest; from += 2, span += 2) {
        const Vector p = site.voxel + side * from * step;
        if (ground_.height.near(static_cast<int>(p.x), static_cast<int>(p.y)) >= 0) break;
      }
    return span < longest;
  }

  const Ground& ground_;
  Farmland farmland_;
  Woodland woodland_;
  Noise broad_, woods_, fine_, roads_, grain_;
};

}  // namespace

CoveredGround cover_ground(const Ground& ground, std::uint64_t seed) {
  const Painter painter(ground, seed);
  const int width = ground.height.width, height = ground.height.height;
  CoveredGround result{{width, height}, {width, height}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Cover cover = painter.cover(x, y);
      result.height.at(x, y) = static_cast<float>(std::max(ground.height.at(x, y), 0.0) + cover.height);
      result.albedo.at(x, y) = cover.color;
    }
  return result;
}

}  // namespace heightfield
