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
  // Requires: the coordinate is finite.
  Fold(double coordinate, int size, Wrap wrap) {
    const auto length = static_cast<double>(size);
    if (wrap == Wrap::clamp) {
      folded_ = coordinate < 0 ? 0 : coordinate > length ? length : coordinate;
      return;
    }
    if (!(std::abs(coordinate) < 0x1p52)) coordinate = std::fmod(coordinate, 2 * length);
    // The quotient may round to a neighbour; the rest is exact, since both terms are multiples of its last place.
    double copies = std::floor(coordinate / length);
    folded_ = coordinate - copies * length;
    if (folded_ < 0) {
      folded_ += length;
      --copies;
    }
    if (folded_ >= length) {
      folded_ -= length;
      ++copies;
    }
    copy_ = static_cast<std::int64_t>(copies);
    is_mirrored_ = wrap == Wrap::mirror && copy_ % 2 != 0;
    if (is_mirrored_) folded_ = length - folded_;
  }

  // In texels of level 0.
  double folded() const { return folded_; }
  // The texel of the endless texture that is `texel` of the folded one, at a level of `size` texels.
  std::int64_t unfolded(std::int64_t texel, std::int64_t size) const {
    return is_mirrored_ ? (copy_ + 1) * size - 1 - texel : copy_ * size + texel;
  }

 private:
  double folded_;
  std::int64_t copy_ = 0;
  bool is_mirrored_ = false;
};

}  // namespace moire
