#include "light/edge_sum.h"

#include "light/edge_angle.h"

namespace shadow_planes {

namespace {

constexpr std::size_t lanes = 4;

struct Edges {
  const double *rx, *ry, *ex, *ey;
  std::size_t count;  // a multiple of `lanes`
  Vector p, normal;
};

// An edge's term is its angle over its sine times its upright part along the normal.
struct Term {
  double cross_squared, dot, upright;
};

[[gnu::always_inline]] inline Term term_of(const Edges& edges, std::size_t k) {
  const double rx = edges.rx[k], ry = edges.ry[k], ex = edges.ex[k], ey = edges.ey[k], z = edges.p.z;
  const double moment = rx * ey - ry * ex;
  return {z * z * (ex * ex + ey * ey) + moment * moment, rx * (rx + ex) + ry * (ry + ey) + z * z,
          z * (edges.normal.x * ey - edges.normal.y * ex) + edges.normal.z * moment};
}

// A plain loop that compilers turn into vectors; without contraction of products its bits do not depend on their width.
// tangents: squared, and 1 over the dot products; they tell where an angle is too wide for the polynomial.
[[gnu::always_inline]] inline void narrow_angles(const Edges& edges, double* __restrict tangents,
                                                 double* __restrict inverses, double* __restrict terms) {
  for (std::size_t k = 0; k < edges.count; ++k) {
    const Term term = term_of(edges, k);
    const double inverse = 1 / term.dot, z = inverse * inverse * term.cross_squared;
    tangents[k] = z;
    inverses[k] = inverse;
    terms[k] = inverse * arctangent_ratio(z) * term.upright;
  }
}

[[gnu::target("avx2")]] void narrow_angles_wide(const Edges& edges, double* tangents, double* inverses, double* terms) {
  narrow_angles(edges, tangents, inverses, terms);
}
void narrow_angles_narrow(const Edges& edges, double* tangents, double* inverses, double* terms) {
  narrow_angles(edges, tangents, inverses, terms);
}

const bool has_wide_vectors = __builtin_cpu_supports("avx2");

}  // namespace

void EdgeSum::flush() {
  if (count_ == 0) return;
  // Edges without extent, at p's foot, add nothing.
  std::size_t padded = count_;
  for (; padded % lanes != 0; ++padded) rx_[padded] = ry_[padded] = ex_[padded] = ey_[padded] = 0;
  const Edges edges{rx_.data(), ry_.data(), ex_.data(), ey_.data(), padded, p_, normal_};
  std::array<double, most> tangents, inverses, terms;
  (has_wide_vectors ? narrow_angles_wide : narrow_angles_narrow)(edges, tangents.data(), inverses.data(), terms.data());
  for (std::size_t k = 0; k < count_; ++k) {
    if (tangents[k] <= steep_squared && inverses[k] > 0) {
      sum_ += terms[k];
    } else {
      const Term term = term_of(edges, k);
      sum_ += angle_over_sine(term.cross_squared, term.dot) * term.upright;
    }
  }
  count_ = 0;
}

}  // namespace shadow_planes
