// The zone plate: a wave whose frequency grows with the distance from the middle.
#include "kinds/factors.h"
#include "kinds/kinds.h"
#include "kinds/separable.h"

namespace pattern {

namespace {

// cos(a r^2) is the real part of e^(i a x^2) e^(i a y^2).
class ZonePlate final : public Separable<ZonePlate, Chirp>, private moire::Spectrum {
 public:
  ZonePlate(const Look& look, double mean, double amplitude, double peak_frequency)
      : Separable(look, Chirp(peak_frequency / (0.5 * std::max(look.size.width, look.size.height)))),
        mean_(mean),
        amplitude_(amplitude) {}

  const moire::Spectrum* spectrum() const override { return this; }

  double grey(std::complex<double> x, std::complex<double> y) const {
    return mean_ + amplitude_ * (x.real() * y.real() - x.imag() * y.imag());
  }

 private:
  double local_frequency(moire::Point p) const override {
    const moire::Point from_middle = p - look().middle();
    return factor().rate() * std::max(std::abs(from_middle.x), std::abs(from_middle.y));
  }
  double amplitude() const override { return amplitude_; }

  double mean_, amplitude_;
};

}  // namespace

std::unique_ptr<moire::Frame> make_zone_plate(const Look& look, double mean, double amplitude, double peak_frequency) {
  return std::make_unique<ZonePlate>(look, mean, amplitude, peak_frequency);
}

}  // namespace pattern
