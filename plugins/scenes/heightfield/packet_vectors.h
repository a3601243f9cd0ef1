// A number for each of several columns: the vectors that packets reckon with.
// Compiled once for each kind of vector: its guard lets it in again for the next one.
#if defined(HEIGHTFIELD_PACKET_VECTORS_H_TOGGLE) == defined(HWY_TARGET_TOGGLE)
#ifdef HEIGHTFIELD_PACKET_VECTORS_H_TOGGLE
#undef HEIGHTFIELD_PACKET_VECTORS_H_TOGGLE
#else
#define HEIGHTFIELD_PACKET_VECTORS_H_TOGGLE
#endif

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();

namespace heightfield::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, 8>;
constexpr D d;
constexpr std::size_t lanes = hn::MaxLanes(d);
using I = hn::Rebind<std::int32_t, D>;
using W = hn::Rebind<std::int64_t, D>;
using Real = hn::Vec<D>;
using Int = hn::Vec<I>;
using Mask = hn::Mask<D>;

constexpr double infinity = std::numeric_limits<double>::infinity();

HWY_INLINE Real real(double value) { return hn::Set(d, value); }
// Of the same bits as std::max and std::min: which of two equal ones is taken matters for signs of zero.
HWY_INLINE Real larger(Real a, Real b) { return hn::Max(b, a); }
HWY_INLINE Real smaller(Real a, Real b) { return hn::Min(b, a); }

template <class Body>
HWY_INLINE void for_each_lane(Mask mask, Body body) {
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(d, mask, bytes.data());
  for (unsigned left = bytes[0]; left != 0; left &= left - 1) body(static_cast<std::size_t>(__builtin_ctz(left)));
}

template <class V, class T>
HWY_INLINE void set_lane(V& vector, std::size_t k, T value) {
  const hn::DFromV<V> tag;
  alignas(64) std::array<hn::TFromV<V>, lanes> values;
  hn::StoreU(vector, tag, values.data());
  values[k] = static_cast<hn::TFromV<V>>(value);
  vector = hn::LoadU(tag, values.data());
}
template <class V>
HWY_INLINE auto lane(V vector, std::size_t k) {
  const hn::DFromV<V> tag;
  alignas(64) std::array<hn::TFromV<V>, lanes> values;
  hn::StoreU(vector, tag, values.data());
  return values[k];
}

}  // namespace heightfield::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#endif
