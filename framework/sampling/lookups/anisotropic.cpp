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
  double width_squared;               // of one read, texels of level 0
  double s_length = 0, t_length = 0;  // the derivative
};

Row row_of(const SurfacePoint& point, int most) {
  const FootprintSides sides(point);
  if (!std::isfinite(sides.longer())) return {.width_squared = sides.longer()};
  const bool is_across = sides.across > sides.down;
  const double longer = std::sqrt(sides.longer()), shorter = std::sqrt(sides.shorter());
  const double width = std::max({shorter, longer / most, 1.0});
  const int count = std::clamp(static_cast<int>(std::ceil(longer / width)), 1, most);
  return {count, width * width, is_across ? point.ds_dx : point.ds_dy, is_across ? point.dt_dx : point.dt_dy};
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
    const auto for_each_place = [&](auto visit) {
      for (int k = 0; k < row.count; ++k) {
        const double along = (k + 0.5) / row.count - 0.5;
        visit(point.s + along * row.s_length, point.t + along * row.t_length);
      }
    };
    // As differences from the middle, so that equal colours stay themselves, bit for bit.
    Rgb first{}, sum{};
    bool is_first = true;
    for_each_place([&](double s, double t) {
      const Rgb read = reader.at(s, t);
      if (is_first) first = read;
      is_first = false;
      sum += read - first;
    });
    deposit_read(first + sum / static_cast<float>(row.count), weight, texture, tally, slot, [&](BaseTexels& names) {
      for_each_place([&](double s, double t) { reader.name(s, t, 1.0 / row.count, names); });
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
