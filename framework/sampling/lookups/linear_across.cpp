// Interpolation across the direction of view: Cohen-Or 1997, section 4.1, eq. 4. The axis interpolated along is that of
// the texture along which the place moves faster when the image point moves sideways, for a column walk its minor axis.
#include <cmath>

#include "sampling/lookups.h"
#include "sampling/lookups/interpolation.h"

namespace moire {

namespace {

class LinearAcross final : public Lookup {
 public:
  Kind kind() const override { return Kind::linear_across; }
  void deposit(const SurfacePoint& point, const Texture& texture, double weight, Tally& tally,
               std::size_t slot) const override {
    const double s = std::ldexp(point.s, -point.level), t = std::ldexp(point.t, -point.level);
    const bool along_s = std::abs(point.ds_dx) > std::abs(point.dt_dx);
    const Between between(along_s ? s : t);
    const std::int64_t other = texel_at(along_s ? t : s);
    const auto add = [&](std::int64_t texel, double share) {
      const Hit hit = along_s ? texture.texel(point.level, texel, other) : texture.texel(point.level, other, texel);
      tally.add(slot, hit.element, weight * share, hit.color);
    };
    add(between.first, 1 - between.fraction);
    if (between.fraction > 0) add(between.first + 1, between.fraction);
  }
};

}  // namespace

std::unique_ptr<Lookup> make_linear_across() { return std::make_unique<LinearAcross>(); }

}  // namespace moire
