// A square-wave grating.
#include "kinds/kinds.h"
#include "kinds/two_valued.h"

namespace pattern {

namespace {

// Stripe k is light where k is even: that about phase k / 2, in cycles.
class Grating final : public TwoValued<Grating> {
 public:
  Grating(const Look& look, const Stripes& stripes)
      : TwoValued(look),
        gradient_(stripes.frequency * direction(stripes.angle_deg)),
        phase_(stripes.phase_deg / 360),
        duty_(stripes.duty) {}

  moire::Hit at(moire::Point p) const { return seen(stripe_at(phase_at(p))); }

  template <class Weights>
  void cover(const Weights& weights, moire::PixelBlock& block) const {
    const HalfPlanes<Weights> beyond(weights, gradient_);
    fill(block, [&](int x, int y, auto deposit) {
      const double phase = phase_at(middle_of(x, y));
      // All that is not below the stripe.
      double above = 1;
      for (std::int64_t k = stripe_at(phase - beyond.reach());; ++k) {
        const double s = phase - end_of(k);
        double rest = beyond(s);
        if constexpr (Weights::is_positive) rest = std::min(rest, above);
        const moire::Hit hit = seen(k);
        deposit(hit.element, above - rest, hit.color);
        above = rest;
        if (s <= -beyond.reach()) break;
      }
    });
  }

 private:
  double phase_at(moire::Point p) const { return dot(gradient_, p - look().middle()) + phase_; }
  std::int64_t stripe_at(double phase) const {
    const double light = std::nearbyint(phase);
    const std::int64_t k = 2 * static_cast<std::int64_t>(light);
    if (std::abs(phase - light) <= duty_ / 2) return k;
    return phase > light ? k + 1 : k - 1;
  }
  // The phase at which stripe k gives way to the next.
  double end_of(std::int64_t k) const {
    const auto half = static_cast<double>(k >> 1);
    return k % 2 == 0 ? half + duty_ / 2 : half + (1 - duty_ / 2);
  }
  moire::Hit seen(std::int64_t k) const { return {part(k), look().greys.of(k % 2 == 0)}; }

  moire::Point gradient_;
  double phase_, duty_;
};

}  // namespace

std::unique_ptr<moire::Frame> make_grating(const Look& look, const Stripes& stripes) {
  return std::make_unique<Grating>(look, stripes);
}

}  // namespace pattern
