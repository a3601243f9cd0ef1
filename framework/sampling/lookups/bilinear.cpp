// Bilinear interpolation between the four nearest texels, visible or not.
#include <cmath>

#include "sampling/lookups.h"
#include "sampling/lookups/interpolation.h"

namespace moire {

namespace {

class Bilinear final : public Lookup {
 public:
  void deposit(const SurfacePoint& point, const Texture& texture, double weight, Tally& tally,
               std::size_t slot) const override {
    const Between s(std::ldexp(point.s, -point.level)), t(std::ldexp(point.t, -point.level));
    for (int j = 0; j < 2; ++j) {
      for (int i = 0; i < 2; ++i) {
        const double share = (i ? s.fraction : 1 - s.fraction) * (j ? t.fraction : 1 - t.fraction);
        if (share == 0) continue;
        const Hit hit = texture.texel(point.level, s.first + i, t.first + j);
        tally.add(slot, hit.element, weight * share, hit.color);
      }
    }
  }
};

}  // namespace

std::unique_ptr<Lookup> make_bilinear() { return std::make_unique<Bilinear>(); }

}  // namespace moire
