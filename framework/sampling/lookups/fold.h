// Where a place far out lies on the texture itself.
#pragma once

#include <smmintrin.h>

#include <cmath>
#include <cstdint>

#include <moire/texture.h>

namespace moire {

// Two numbers that are computed with together: along s, along t.
using Pair = double __attribute__((vector_size(16)));

inline Pair floor_of(Pair x) { return _mm_floor_pd(x); }

// A place, brought back to 0 .. size along both axes by whole copies of the texture, in doubles: near a horizon
// coordinates reach millions of texels, of which a float would keep no fraction. All levels of a pyramid share it, for
// their borders are at the same places. Places beyond 2^52 texels lose the number of their copy and no more.
class Fold {
 public:
  // The size of a texture, texels of level 0.
  struct Period {
    Pair size, inverse;
    Wrap wrap;

    Period(int width, int height, Wrap own_wrap)
        : size{static_cast<double>(width), static_cast<double>(height)}, inverse(1 / size), wrap(own_wrap) {}
  };

  // Requires: the place is finite.
  Fold(Pair place, const Period& period) {
    if (period.wrap == Wrap::clamp) {
      folded_ = place < 0 ? Pair{} : place > period.size ? period.size : place;
      return;
    }
    if (!(std::abs(place[0]) < 0x1p52 && std::abs(place[1]) < 0x1p52)) {
      place = Pair{std::fmod(place[0], 2 * period.size[0]), std::fmod(place[1], 2 * period.size[1])};
    }
    // The number of the copy may be off by one; the rest is exact, since both terms are multiples of its last place.
    copy_ = floor_of(place * period.inverse);
    folded_ = place - copy_ * period.size;
    copy_ = folded_ < 0 ? copy_ - 1 : copy_;
    folded_ = folded_ < 0 ? folded_ + period.size : folded_;
    copy_ = folded_ >= period.size ? copy_ + 1 : copy_;
    folded_ = folded_ >= period.size ? folded_ - period.size : folded_;
    if (period.wrap == Wrap::mirror) {
      mirrored_ = copy_ - 2 * floor_of(copy_ / 2);
      folded_ = mirrored_ > 0 ? period.size - folded_ : folded_;
    }
  }

  // In texels of level 0.
  Pair folded() const { return folded_; }
  // The texel of the endless texture that is `texel` of the folded one along an axis (0: s, 1: t), at a level that has
  // `size` of them.
  std::int64_t unfolded(int axis, std::int64_t texel, std::int64_t size) const {
    const auto copy = static_cast<std::int64_t>(copy_[axis]);
    return mirrored_[axis] > 0 ? (copy + 1) * size - 1 - texel : copy * size + texel;
  }

 private:
  Pair folded_, copy_{}, mirrored_{};  // the last: 1 where the copy runs backwards
};

}  // namespace moire
