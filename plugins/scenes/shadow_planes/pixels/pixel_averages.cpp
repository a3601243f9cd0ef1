#include "pixels/pixel_averages.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "pixels/tiles.h"

namespace shadow_planes {

PixelAverages::PixelAverages(const World& world, const Camera& camera, const VisibleParts& visible, Options options)
    : visible_(visible), is_flat_(options.is_flat), sky_(world.sky), faces_(world.faces.size()) {
  const moire::ImageSize size{Tiles::rounded_up(camera.size.width), Tiles::rounded_up(camera.size.height)};
  std::vector<Part> parts;
  visible.in({0, 0, static_cast<double>(size.width), static_cast<double>(size.height)}, parts);
  for (const Part& part : parts) {
    if (part.face == Part::none || faces_[part.face]) continue;
    const moire::Color& reflectance = world.faces[part.face].reflectance;
    const moire::Color& sent = options.is_flat ? world.light.flat : world.light.color;
    const double unit = options.is_flat ? 1 : 1 / std::numbers::pi;
    const std::array<double, 3> reflected{reflectance.r, reflectance.g, reflectance.b};
    const std::array<double, 3> light{unit * reflected[0] * sent.r, unit * reflected[1] * sent.g,
                                      unit * reflected[2] * sent.b};
    const double most = std::max({light[0], light[1], light[2]});
    faces_[part.face] = std::make_unique<ShadedFace>(
        ShadedFace{SeenFace(world, part.face, camera, size),
                   {reflected[0] * world.ambient.r, reflected[1] * world.ambient.g, reflected[2] * world.ambient.b},
                   light,
                   most > 0 ? options.tolerance / most : std::numeric_limits<double>::infinity()});
  }
}

double PixelAverages::integrate(const moire::Filter*, moire::PixelBlock& block) const {
  return Tiles(visible_, faces_, sky_, is_flat_, block).integrate();
}

}  // namespace shadow_planes
