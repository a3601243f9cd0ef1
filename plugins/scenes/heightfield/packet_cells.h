// Cells of the terrain, one for each lane.
// Compiled once for each kind of vector: its guard lets it in again for the next one.
#if defined(HEIGHTFIELD_PACKET_CELLS_H_TOGGLE) == defined(HWY_TARGET_TOGGLE)
#ifdef HEIGHTFIELD_PACKET_CELLS_H_TOGGLE
#undef HEIGHTFIELD_PACKET_CELLS_H_TOGGLE
#else
#define HEIGHTFIELD_PACKET_CELLS_H_TOGGLE
#endif

#include "packet_vectors.h"
#include "voxels.h"

HWY_BEFORE_NAMESPACE();

namespace heightfield::HWY_NAMESPACE {

struct Cells {
  Real height, r, g, b;
};

// Rows of four floats to columns, in every block of four lanes.
template <class F>
struct Columns {
  hn::Vec<F> height, r, g, b;
};
template <class F, class Load>
HWY_INLINE Columns<F> columns(F f, Load load) {
  constexpr hn::Repartition<double, F> pair;
  const auto c0 = load(0), c1 = load(1), c2 = load(2), c3 = load(3);
  const auto low01 = hn::InterleaveLower(f, c0, c1), low23 = hn::InterleaveLower(f, c2, c3);
  const auto high01 = hn::InterleaveUpper(f, c0, c1), high23 = hn::InterleaveUpper(f, c2, c3);
  const auto lower = [&](auto a, auto b) HWY_ATTR {
    return hn::BitCast(f, hn::InterleaveLower(pair, hn::BitCast(pair, a), hn::BitCast(pair, b)));
  };
  const auto upper = [&](auto a, auto b) HWY_ATTR {
    return hn::BitCast(f, hn::InterleaveUpper(pair, hn::BitCast(pair, a), hn::BitCast(pair, b)));
  };
  return {lower(low01, low23), upper(low01, low23), lower(high01, high23), upper(high01, high23)};
}

template <class Tag>
HWY_INLINE Cells load_cells(Tag tag, const Cell* const* cells) {
  constexpr hn::Rebind<float, Tag> f;
  constexpr hn::Full128<float> four;
  const auto load = [&](std::size_t k) HWY_ATTR { return hn::LoadU(four, &cells[k]->height); };
  if constexpr (hn::MaxLanes(tag) == 2) {
    const auto c = columns(four, [&](std::size_t k) HWY_ATTR { return load(k % 2); });
    const auto promoted = [&](auto v) HWY_ATTR { return hn::PromoteTo(tag, hn::LowerHalf(f, v)); };
    return {promoted(c.height), promoted(c.r), promoted(c.g), promoted(c.b)};
  } else {
    const auto rows = [&](std::size_t k) HWY_ATTR {
      if constexpr (hn::MaxLanes(tag) == 4) {
        return load(k);
      } else {
        return hn::Combine(f, load(k + 4), load(k));
      }
    };
    const auto c = columns(f, rows);
    return {hn::PromoteTo(tag, c.height), hn::PromoteTo(tag, c.r), hn::PromoteTo(tag, c.g), hn::PromoteTo(tag, c.b)};
  }
}

}  // namespace heightfield::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#endif
