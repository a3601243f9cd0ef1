// A texture in the hands of OpenImageIO's TextureSystem, behind the module's edge.
#pragma once

#include <string>

#include <moire/color.h>
#include <moire/texture.h>

namespace moire {

// How OpenImageIO is asked to filter, in its own words.
struct OiioOptions {
  enum class Mip { anisotropic, trilinear, one_level, none };
  enum class Interpolation { smart_bicubic, bicubic, bilinear, closest };
  Mip mip = Mip::anisotropic;
  Interpolation interpolation = Interpolation::smart_bicubic;
  int anisotropic = 32;  // largest ratio of the footprint's axes
  float width = 1;       // what the derivatives are multiplied by
};

// May be used from many threads.
class OiioTexture {
 public:
  virtual ~OiioTexture() = default;
  // Colours around a point's place, in linear light; what is not a number if OpenImageIO reports an error.
  virtual Color read(const SurfacePoint& point, const OiioOptions& options) const noexcept = 0;
};

// Exported by the module, as those in images.h are. The pyramid outlives what is made of it.
using MakeOiioTexture = OiioTexture*(const Pyramid& pyramid, Wrap wrap, std::string& problem) noexcept;

inline constexpr char make_oiio_texture_symbol[] = "moire_make_oiio_texture";

}  // namespace moire
