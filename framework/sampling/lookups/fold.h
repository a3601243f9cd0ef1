// Where a place far out lies on the texture itself.
#pragma once

#include <cmath>
#include <cstdint>

#include <moire/texture.h>

namespace moire {

// One texture coordinate, brought back to 0 .. size by whole copies of the texture, in doubles: near a horizon
// coordinates reach millions of texels, of which a float would keep no fraction. All levels of a pyramid share it, for
// their borders are at the same places. Places beyond 2^52 texels lose the number of their copy and no more; one that
// is infinite or not a number stays none.
class Fold {
 public:
  // One axis of a texture.
  struct Axis {
    double size, inverse;  // texels of level 0
    Wrap wrap;

    Axis(int texels, Wrap own_wrap) : size(texels), inverse(1 / size), wrap(own_wrap) {}
  };

  // Requires: the coordinate is finite.
  Fold(double coordinate, const Axis& axis) {
    if (axis.wrap == Wrap::clamp) {
      folded_ = coordinate < 0 ? 0 : coordinate > axis.size ? axis.size : coordinate;
      return;
    }
    if (!(std::abs(coordinate) < 0x1p52)) coordinate = std::fmod(coordinate, 2 * axis.size);
    // The number of the copy may be off by one; the rest is exact, since both terms are multiples of its last place.
    copy_ = std::floor(coordinate * axis.inverse);
    folded_ = coordinate - copy_ * axis.size;
    if (folded_ < 0) {
      folded_ += axis.size;
      --copy_;
    }
    if (folded_ >= axis.size) {
      folded_ -= axis.size;
      ++copy_;
    }
    is_mirrored_ = axis.wrap == Wrap::mirror && static_cast<std::int64_t>(copy_) % 2 != 0;
    if (is_mirrored_) folded_ = axis.size - folded_;
  }

  // In texels of level 0.
  double folded() const { return folded_; }
  // The texel of the endless texture that is `texel` of the folded one, at a level of `size` texels.
  std::int64_t unfolded(std::int64_t texel, std::int64_t size) const {
    const auto copy = static_cast<std::int64_t>(copy_);
    return is_mirrored_ ? (copy + 1) * size - 1 - texel : copy * size + texel;
  }

 private:
  double folded_, copy_ = 0;
  bool is_mirrored_ = false;
};

}  // namespace moire
