// The piecewise cubics of Mitchell and Netravali, "Reconstruction Filters in Computer Graphics" (SIGGRAPH 1988,
// doi:10.1145/54852.378514), eq. 8.
#include <array>
#include <cmath>

#include "sampling/filters.h"
#include "sampling/filters/transform.h"

namespace moire {

namespace {

class Mitchell final : public Filter {
 public:
  Mitchell(double b, double c) : b_(b), c_(c) {}
  double radius() const override { return 2; }
  double at(double x) const override {
    const double d = std::abs(x);
    if (d < 1) return ((12 - 9 * b_ - 6 * c_) * d * d * d + (-18 + 12 * b_ + 6 * c_) * d * d + (6 - 2 * b_)) / 6;
    if (d < 2)
      return ((-b_ - 6 * c_) * d * d * d + (6 * b_ + 30 * c_) * d * d + (-12 * b_ - 48 * c_) * d + (8 * b_ + 24 * c_)) /
             6;
    return 0;
  }
  double transfer(double frequency) const override {
    return cosine_transform([this](double x) { return at(x); }, knots(), frequency);
  }
  std::span<const double> knots() const override {
    static constexpr std::array places{1.0, 2.0};
    return places;
  }

 private:
  double b_, c_;
};

}  // namespace

std::unique_ptr<Filter> make_mitchell(double b, double c) { return std::make_unique<Mitchell>(b, c); }

}  // namespace moire
