// Mip-maps (Williams 1983, doi:10.1145/800059.801126): one level, or two, of a texture averaged beforehand. The
// footprint is taken for a square: D, the longer of the two derivatives, is the lecture's choice (Maddock, 8.1).
#include <cmath>

#include "sampling/lookups.h"
#include "sampling/lookups/footprint.h"
#include "sampling/lookups/mip_level.h"
#include "sampling/lookups/pyramid_reader.h"

namespace moire {

namespace {

enum class Side { max, min, area };

// Squared, texels of level 0.
double side_of(const SurfacePoint& point, Side side) {
  if (side == Side::area) {
    return std::abs(static_cast<double>(point.ds_dx) * point.dt_dy - static_cast<double>(point.dt_dx) * point.ds_dy);
  }
  const FootprintSides sides(point);
  return side == Side::max ? sides.longer() : sides.shorter();
}

class Mipmap final : public Lookup {
 public:
  explicit Mipmap(const Settings& settings)
      : side_(settings.text("mipmap.level") == "max"   ? Side::max
              : settings.text("mipmap.level") == "min" ? Side::min
                                                       : Side::area),
        across_(settings.text("mipmap.between") == "trilinear" ? Across::two : Across::nearest),
        within_(settings.text("mipmap.within") == "bilinear" ? Within::bilinear : Within::nearest),
        bias_(settings.real("mipmap.bias")),
        footprint_(footprint_of(settings.text("mipmap.footprint"))) {}

  Footprint footprint() const override { return footprint_; }

  void deposit(const SurfacePoint& point, const Texture& texture, double weight, Tally& tally,
               std::size_t slot) const override {
    if (deposit_nowhere(point, weight, tally, slot)) return;
    const Pyramid& pyramid = texture.pyramid();
    const double level = mip_level(side_of(point, side_), bias_, pyramid.levels() - 1);
    const PyramidReader reader(pyramid, texture.wrap(), level, across_, within_);
    const Pair place{point.s, point.t};
    deposit_read(reader.at(place), weight, texture, tally, slot,
                 [&](BaseTexels& names) { reader.name(place, 1, names); });
  }

 private:
  Side side_;
  Across across_;
  Within within_;
  double bias_;
  Footprint footprint_;
};

}  // namespace

std::unique_ptr<Lookup> make_mipmap(const Settings& settings) { return std::make_unique<Mipmap>(settings); }

}  // namespace moire
