// OpenImageIO's TextureSystem, what a user would pick instead. It gets the levels of our own pyramid, so that only the
// filtering is compared. It does not say which texels it read: the texel at the place stands for all of them, with full
// weight and the colour read, so that leak, weight error and coverage of this lookup mean nothing.
#include "images/oiio_texture.h"

#include <array>
#include <cmath>

#include "sampling/lookups.h"
#include "sampling/lookups/footprint.h"
#include "sampling/lookups/interpolation.h"

namespace moire {

namespace {

OiioOptions::Mip mip_of(const std::string& name) {
  if (name == "trilinear") return OiioOptions::Mip::trilinear;
  if (name == "one_level") return OiioOptions::Mip::one_level;
  return name == "none" ? OiioOptions::Mip::none : OiioOptions::Mip::anisotropic;
}

OiioOptions::Interpolation interpolation_of(const std::string& name) {
  if (name == "bicubic") return OiioOptions::Interpolation::bicubic;
  if (name == "bilinear") return OiioOptions::Interpolation::bilinear;
  return name == "closest" ? OiioOptions::Interpolation::closest : OiioOptions::Interpolation::smart_bicubic;
}

class Oiio final : public Lookup {
 public:
  explicit Oiio(const Settings& settings)
      : options_{mip_of(settings.text("oiio.mip")), interpolation_of(settings.text("oiio.interpolation")),
                 static_cast<int>(settings.integer("oiio.anisotropic")),
                 static_cast<float>(settings.real("oiio.width"))},
        footprint_(footprint_of(settings.text("oiio.footprint"))) {}

  Footprint footprint() const override { return footprint_; }

  void deposit(const SurfacePoint& point, const Texture& texture, double weight, Tally& tally,
               std::size_t slot) const override {
    const Color color = texture.oiio().read(point, options_);
    const bool is_place = std::abs(point.s) < 0x1p62 && std::abs(point.t) < 0x1p62;
    const Element element = is_place ? texel_element(0, texel_at(point.s), texel_at(point.t)) : point.hit.element;
    tally.add(slot, element, weight, color);
  }

 private:
  OiioOptions options_;
  Footprint footprint_;
};

}  // namespace

std::unique_ptr<Lookup> make_oiio(const Settings& settings) { return std::make_unique<Oiio>(settings); }

}  // namespace moire
