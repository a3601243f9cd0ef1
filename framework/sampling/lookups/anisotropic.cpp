// Several reads of a pyramid in a row along the longer derivative, each as wide as the shorter one (after McCormack et
// al. 1999, "Feline", doi:10.1145/311535.311562, with equal weights, which is nearer to a pixel's box).
#include <algorithm>
#include <cmath>

#include "sampling/lookups.h"
#include "sampling/lookups/footprint.h"
#include "sampling/lookups/mip_level.h"
#include "sampling/lookups/pyramid_reader.h"

namespace moire {

namespace {

// So many reads, evenly spaced over the longer derivative.
struct Row {
  int count = 1;
  double width_squared;  // of one read, texels of level 0
  Pair length{};         // the derivative
};

Row row_of(const SurfacePoint& point, int most) {
  const FootprintSides sides(point);
  if (!std::isfinite(sides.longer())) return {.width_squared = sides.longer()};
  const bool is_across = sides.across > sides.down;
  const double longer = std::sqrt(sides.longer()), shorter = std::sqrt(sides.shorter());
  const double width = std::max({shorter, longer / most, 1.0});
  const int count = std::clamp(static_cast<int>(std::round(longer / width)), 1, most);
  return {count, width * width, is_across ? Pair{point.ds_dx, point.dt_dx} : Pair{point.ds_dy, point.dt_dy}};
}

class Anisotropic final : public Lookup {
 public:
  explicit Anisotropic(const Settings& settings)
      : probes_(static_cast<int>(settings.integer("anisotropic.probes"))),
        bias_(settings.real("anisotropic.bias")),
        footprint_(footprint_of(settings.text("anisotropic.footprint"))) {}

  Footprint footprint() const override { return footprint_; }

  void deposit(const SurfacePoint& point, const Texture& texture, double weight, Tally& tally,
               std::size_t slot) const override {
    if (deposit_nowhere(point, weight, tally, slot)) return;
    const Row row = row_of(point, probes_);
    const Pyramid& pyramid = texture.pyramid();
    const PyramidReader reader(pyramid, texture.wrap(), mip_level(row.width_squared, bias_, pyramid.levels() - 1));
    const auto place = [&](int k) { return Pair{point.s, point.t} + ((k + 0.5) / row.count - 0.5) * row.length; };
    // As differences from the first, so that equal colours stay themselves, bit for bit.
    const Rgb first = reader.at(place(0));
    Rgb sum{};
    for (int k = 1; k < row.count; ++k) sum += reader.at(place(k)) - first;
    deposit_read(first + sum / static_cast<float>(row.count), weight, texture, tally, slot, [&](BaseTexels& names) {
      for (int k = 0; k < row.count; ++k) reader.name(place(k), 1.0 / row.count, names);
    });
  }

 private:
  int probes_;
  double bias_;
  Footprint footprint_;
};

}  // namespace

std::unique_ptr<Lookup> make_anisotropic(const Settings& settings) { return std::make_unique<Anisotropic>(settings); }

}  // namespace moire
