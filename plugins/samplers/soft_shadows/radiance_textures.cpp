#include "radiance_textures.h"

#include <algorithm>
#include <cmath>

namespace soft_shadows {

namespace {

// The two cells whose middles lie around a place in [0, 1], and how near the second one is.
struct Between {
  std::size_t first, second;
  double toward_second;
};

Between between(double place, int cells) {
  const double last = cells - 1;
  const double at = std::clamp(place * cells - 0.5, 0.0, last), first = std::min(std::floor(at), last);
  return {static_cast<std::size_t>(first), static_cast<std::size_t>(std::min(first + 1, last)), at - first};
}

std::size_t cell(double place, int cells) {
  return static_cast<std::size_t>(std::clamp(std::floor(place * cells), 0.0, cells - 1.0));
}

}  // namespace

RadianceTextures::RadianceTextures(const moire::Receivers& receivers, std::vector<moire::LightPoint> lights, int texels,
                                   moire::ShadowEdges edges)
    : receivers_(receivers),
      lights_(std::move(lights)),
      texels_(texels),
      edges_(edges),
      textures_(std::make_unique<Texture[]>(receivers.count())) {}

double RadianceTextures::irradiance(const moire::ReceiverPoint& place, Interpolation interpolation) const {
  const moire::IrradianceMap& from = map(place.receiver);
  const auto columns = static_cast<std::size_t>(from.columns);
  if (interpolation == Interpolation::nearest) {
    return from.cells[cell(place.t, from.rows) * columns + cell(place.s, from.columns)];
  }
  const Between s = between(place.s, from.columns), t = between(place.t, from.rows);
  const auto along = [&](std::size_t row) {
    const double a = from.cells[row * columns + s.first], b = from.cells[row * columns + s.second];
    return a + s.toward_second * (b - a);
  };
  const double above = along(t.first);
  return above + t.toward_second * (along(t.second) - above);
}

const moire::IrradianceMap& RadianceTextures::map(std::uint32_t receiver) const {
  Texture& texture = textures_[receiver];
  std::call_once(texture.once, [&] {
    const auto [s, t] = receivers_.extent(receiver);
    const auto side = [&](double length) {
      return std::max(1, static_cast<int>(std::lround(texels_ * length / std::max(s, t))));
    };
    moire::IrradianceMap& made = texture.map;
    made.columns = side(s), made.rows = side(t);
    made.cells.assign(static_cast<std::size_t>(made.columns) * static_cast<std::size_t>(made.rows), 0.0F);
    receivers_.add_hard_shadows(receiver, lights_, edges_, made);
  });
  return texture.map;
}

}  // namespace soft_shadows
