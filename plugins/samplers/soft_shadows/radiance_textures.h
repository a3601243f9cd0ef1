// Heckbert and Herf's radiance textures: of each receiver, the average of many hard shadows.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include <moire/receivers.h>

namespace soft_shadows {

enum class Interpolation { nearest, bilinear };

// Each texture is made when it is first looked up. Safe from many threads.
class RadianceTextures {
 public:
  // `texels`: along the longer side of each receiver. Requires: `receivers` outlives this.
  RadianceTextures(const moire::Receivers& receivers, std::vector<moire::LightPoint> lights, int texels,
                   moire::ShadowEdges edges);

  // The irradiance at a place of a receiver: that of its texel, or between the middles of four.
  double irradiance(const moire::ReceiverPoint& place, Interpolation interpolation) const;

 private:
  struct Texture {
    std::once_flag once;
    moire::IrradianceMap map;
  };
  const moire::IrradianceMap& map(std::uint32_t receiver) const;

  const moire::Receivers& receivers_;
  std::vector<moire::LightPoint> lights_;
  int texels_;
  moire::ShadowEdges edges_;
  std::unique_ptr<Texture[]> textures_;
};

}  // namespace soft_shadows
