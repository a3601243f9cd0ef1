// Two numbers at once: what is done for both edges of a curve.
#pragma once

#include <smmintrin.h>

namespace area {

struct Pair {
  __m128d lanes;

  Pair() : lanes(_mm_setzero_pd()) {}
  explicit Pair(__m128d both) : lanes(both) {}
  explicit Pair(double both) : lanes(_mm_set1_pd(both)) {}
  Pair(double first, double second) : lanes(_mm_set_pd(second, first)) {}

  double first() const { return _mm_cvtsd_f64(lanes); }
  double second() const { return _mm_cvtsd_f64(_mm_unpackhi_pd(lanes, lanes)); }
  double difference() const { return first() - second(); }

  friend Pair operator+(Pair p, Pair q) { return Pair(_mm_add_pd(p.lanes, q.lanes)); }
  friend Pair operator-(Pair p, Pair q) { return Pair(_mm_sub_pd(p.lanes, q.lanes)); }
  friend Pair operator*(Pair p, Pair q) { return Pair(_mm_mul_pd(p.lanes, q.lanes)); }
  friend Pair operator/(Pair p, Pair q) { return Pair(_mm_div_pd(p.lanes, q.lanes)); }
  // All bits of a lane where it holds, for chosen().
  friend Pair operator<=(Pair p, Pair q) { return Pair(_mm_cmple_pd(p.lanes, q.lanes)); }
};

inline Pair max(Pair p, Pair q) { return Pair(_mm_max_pd(p.lanes, q.lanes)); }
inline Pair min(Pair p, Pair q) { return Pair(_mm_min_pd(p.lanes, q.lanes)); }
inline Pair sqrt(Pair p) { return Pair(_mm_sqrt_pd(p.lanes)); }
inline Pair chosen(Pair condition, Pair yes, Pair no) {
  return Pair(_mm_blendv_pd(no.lanes, yes.lanes, condition.lanes));
}

}  // namespace area
