// The sum of all light of a picture: constant under translation if every part counts by its area (Catmull 1978).
#include "metrics/energy.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "metrics/registry.h"

namespace moire {

namespace {

constexpr Quantity quantities[] = {
    {.name = "energy.mean",
     .unit = "",
     .meaning = "mean over frames, pixels and channels, linear light",
     .is_judged = false},
    {.name = "energy.swing",
     .unit = "",
     .meaning = "brightest frame less darkest, over the mean of all; by itself no fault, the reference has its own",
     .is_judged = false,
     .is_main = true},
    {.name = "energy.error",
     .unit = "",
     .meaning = "largest difference of a frame's light from that of the reference, over the reference's mean",
     .is_main = true},
};

double mean_light(const PixelBlock& block) {
  double sum = 0;
  for (std::size_t slot = 0; slot < block.slots(); ++slot) {
    const Color c = block.color(slot);
    sum += double{c.r} + double{c.g} + double{c.b};
  }
  return sum / (3 * static_cast<double>(block.slots()));
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

void Energy::see(const FrameView& view) {
  own_.push_back(mean_light(view.own));
  reference_.push_back(mean_light(*view.reference));
}

std::vector<Measurement> Energy::finish() const {
  const auto [darkest, brightest] = std::minmax_element(own_.begin(), own_.end());
  double error = 0;
  for (std::size_t k = 0; k < own_.size(); ++k) {
    const double difference = std::abs(own_[k] - reference_[k]);
    if (!(difference <= error)) error = difference;  // what is not a number stays
  }
  const double all = mean(own_);
  return {{"energy.mean", all},
          {"energy.swing", (*brightest - *darkest) / all},
          {"energy.error", error / mean(reference_)}};
}

const PassDescription energy_description{
    .name = "energy",
    .summary = "How much light a picture has in all, from frame to frame: constant where things only move.",
    .source = "Catmull 1978, \"Anti-aliasing\": the picket fence",
    .parameters = {},
    .quantities = quantities,
};

std::unique_ptr<TemporalMetric> make_energy(const Settings&, ImageSize image) {
  return std::make_unique<Energy>(image);
}

}  // namespace moire
