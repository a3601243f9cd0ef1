// Colour error against the reference image.
#include <algorithm>
#include <cmath>

#include "metrics/registry.h"

namespace moire {

namespace {

using namespace parameter;

constexpr Parameter parameters[] = {
    choice("space", "linear", "linear srgb", "what is compared: linear light, or sRGB code values"),
    real("bad_above", 8, 0, 255, "levels", "a pixel is bad if a channel is off by more"),
    real("map_scale", 32, 1e-6, 255, "levels", "error at the end of the error maps' colour scale"),
    flag("maps", true, "error maps are made: pictures of where the errors are"),
};

constexpr Quantity quantities[] = {
    {.name = "error.rmse",
     .unit = "levels",
     .meaning = "root of the mean over pixels and channels of (value - reference)^2; levels of 1/255",
     .is_main = true},
    {.name = "error.mae", .unit = "levels", .meaning = "mean over pixels and channels of |value - reference|"},
    {.name = "error.max", .unit = "levels", .meaning = "largest |value - reference| of any pixel and channel"},
    {.name = "error.bad_pixels",
     .unit = "",
     .meaning = "share of pixels of which a channel is off by more than bad_above"},
};

// The larger of two errors, and not-a-number if one of them is: it must never pass for a small error.
double larger(double a, double b) { return std::isnan(a) || a > b ? a : b; }

class ErrorMetric final : public Metric {
 public:
  explicit ErrorMetric(const Settings& settings)
      : space_(settings.text("space") == "linear" ? Space::linear : Space::srgb),
        bad_above_(settings.real("bad_above")),
        map_scale_(settings.real("map_scale")),
        has_maps_(settings.flag("maps")) {}

  std::vector<Measurement> finish(const Judged& judged) override {
    differences_ = differences(judged.picture, judged.reference, space_);
    double sum = 0, largest = 0;
    std::size_t bad = 0;
    for (std::size_t k = 0; k < differences_.size(); k += 3) {
      double worst = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        const double size = std::abs(differences_[k + c]);
        sum += size;
        worst = larger(worst, size);
      }
      largest = larger(largest, worst);
      if (!(worst <= bad_above_)) ++bad;
    }
    const auto channels = static_cast<double>(differences_.size());
    return {{"error.rmse", root_mean_square(differences_)},
            {"error.mae", sum / channels},
            {"error.max", largest},
            {"error.bad_pixels", static_cast<double>(bad) / (channels / 3)}};
  }

  // The mean over a pixel's channels.
  std::vector<Map> maps() const override {
    if (!has_maps_) return {};
    Map absolute{"error_absolute", map_scale_, {}}, sign{"error_signed", map_scale_, {}};
    for (std::size_t k = 0; k < differences_.size(); k += 3) {
      const double* d = &differences_[k];
      absolute.values.push_back((std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2])) / 3);
      sign.values.push_back((d[0] + d[1] + d[2]) / 3);
    }
    return {std::move(absolute), std::move(sign)};
  }

 private:
  Space space_;
  double bad_above_, map_scale_;
  bool has_maps_;
  std::vector<double> differences_;
};

}  // namespace

const PassDescription error_description{
    .name = "error",
    .summary = "How far the colours are from the reference image.",
    .source = "",
    .parameters = parameters,
    .quantities = quantities,
};

std::unique_ptr<Metric> make_error(const Settings& settings) { return std::make_unique<ErrorMetric>(settings); }

}  // namespace moire
