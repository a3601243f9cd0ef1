// The tent, and the Bartlett windows of Maddock's Table 4.1, which are tents over the points of a pattern.
#include <algorithm>
#include <cmath>

#include "sampling/filters.h"
#include "sampling/filters/sinc.h"

namespace moire {

namespace {

class Tent final : public Filter {
 public:
  explicit Tent(double radius) : radius_(radius) {}
  double radius() const override { return radius_; }
  double at(double x) const override { return std::max(0.0, 1 - std::abs(x) / radius_) / radius_; }
  double transfer(double frequency) const override {
    const double root = sinc(frequency * radius_);
    return root * root;
  }
  std::span<const double> knots() const override { return {&radius_, 1}; }

 private:
  double radius_;
};

}  // namespace

std::unique_ptr<Filter> make_tent(double radius) { return std::make_unique<Tent>(radius); }

std::unique_ptr<Filter> make_bartlett(int taps, double spacing) { return make_tent((taps + 1) / 2 * spacing); }

}  // namespace moire
