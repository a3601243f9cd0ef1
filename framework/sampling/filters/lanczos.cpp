// Lanczos' filter: sinc(x) sinc(x / n), cut off at n (Duchon 1979,
// doi:10.1175/1520-0450(1979)018<1016:LFIOAT>2.0.CO;2), divided by its integral.
#include <cmath>
#include <vector>

#include "sampling/filters.h"
#include "sampling/filters/sinc.h"
#include "sampling/filters/transform.h"

namespace moire {

namespace {

class Lanczos final : public Filter {
 public:
  explicit Lanczos(int lobes) : lobes_(lobes) {
    for (int k = 1; k <= lobes; ++k) knots_.push_back(k);
    integral_ = cosine_transform([this](double x) { return windowed(x); }, knots_, 0);
  }
  double radius() const override { return lobes_; }
  double at(double x) const override { return windowed(x) / integral_; }
  double transfer(double frequency) const override {
    return cosine_transform([this](double x) { return at(x); }, knots_, frequency);
  }
  std::span<const double> knots() const override { return knots_; }

 private:
  double windowed(double x) const { return std::abs(x) < lobes_ ? sinc(x) * sinc(x / lobes_) : 0; }

  double lobes_, integral_ = 1;
  std::vector<double> knots_;
};

}  // namespace

std::unique_ptr<Filter> make_lanczos(int lobes) { return std::make_unique<Lanczos>(lobes); }

}  // namespace moire
