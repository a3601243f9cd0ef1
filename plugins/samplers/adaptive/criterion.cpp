#include "criterion.h"

namespace adaptive {

Criterion::Criterion(const moire::Settings& settings, moire::Blend blend)
    : colors_(settings.text("criterion") != "element"),
      elements_(settings.text("criterion") != "color"),
      threshold_(settings.real("threshold") / 255),
      blend_(blend) {}

bool Criterion::differ(moire::Color low, moire::Color high) const {
  const auto code = [&](float channel) {
    return blend_ == moire::Blend::as_stored ? channel : moire::linear_to_srgb(channel);
  };
  const auto is_wide = [&](float from, float to) { return from != to && code(to) - code(from) > threshold_; };
  return is_wide(low.r, high.r) || is_wide(low.g, high.g) || is_wide(low.b, high.b);
}

}  // namespace adaptive
