// Error over samples: how fast a method gets better. The slopes over all settings of a method are fitted by
// run/convergence_analysis.h when all scenes are done.
#include <array>
#include <cmath>

#include "metrics/registry.h"

namespace moire {

namespace {

using namespace parameter;

constexpr Parameter parameters[] = {
    integer("replicates", 4, 1, 10000, "pictures",
            "pictures with independent random numbers, for methods that draw any"),
    text("over", "n points",
         "settings that change the number of samples: contenders that differ in nothing else are one family"),
    real("from_samples", 16, 1, 1e9, "per pixel", "slopes are fitted from so many samples on"),
    text("against", "", "the family whose samples at equal error all contenders' are compared with; \"\": none"),
    text("theory", "",
         "what is expected, as \"SCENE/FAMILY: SLOPE [CONSTANT]; ...\", of an error CONSTANT N^SLOPE; a family's name "
         "is "
         "its contenders' without the settings of `over`"),
};

constexpr Quantity quantities[] = {
    {.name = "convergence.samples", .unit = "per pixel", .meaning = "points traced", .is_judged = false},
    {.name = "convergence.rmse",
     .unit = "",
     .meaning = "root mean square of value - reference over all channels, pixels and replicates, in linear light, 1 "
                "full scale; low and high: 95 % confidence from 16 groups of pixels in each replicate",
     .is_main = true},
    {.name = "convergence.slope",
     .unit = "",
     .meaning = "of log rmse on log samples over a family, weighed by their intervals; low and high: 95 % confidence, "
                "from the intervals or from the scatter about the line, whichever is wider"},
    {.name = "convergence.constant",
     .unit = "",
     .meaning = "c of the fitted rmse c N^slope; where theory gives the slope, with that slope",
     .is_judged = false},
    {.name = "convergence.saving",
     .unit = "times",
     .meaning = "samples that the family of `against` takes for the same rmse, over own samples; read off straight "
                "lines between its sizes in log rmse over log samples, beyond its ends along its fitted slope",
     .lower_is_better = false,
     .is_main = true},
};

constexpr std::size_t groups = 16;

class ConvergenceMetric final : public Metric {
 public:
  explicit ConvergenceMetric(const Settings& settings)
      : replicates_(static_cast<std::size_t>(settings.integer("replicates"))) {}

  std::size_t replicates() const override { return replicates_; }

  std::vector<Measurement> finish(const Judged& judged) override {
    std::vector<double> squares;  // the mean of each group of each picture
    if (judged.replicates.empty()) {
      add_groups(judged.picture, judged.reference, squares);
    } else {
      for (const Picture& picture : judged.replicates.first(replicates_))
        add_groups(picture, judged.reference, squares);
    }
    const auto count = static_cast<double>(squares.size());
    double mean = 0, spread = 0;
    for (double square : squares) mean += square / count;
    for (double square : squares) spread += (square - mean) * (square - mean);
    const double margin = 1.96 * std::sqrt(spread / (count - 1) / count);
    const double pixels = static_cast<double>(judged.picture.pixels.size());
    return {{"convergence.samples", static_cast<double>(judged.counters.queries) / pixels},
            {"convergence.rmse", std::sqrt(mean), std::sqrt(std::max(0.0, mean - margin)), std::sqrt(mean + margin)}};
  }

 private:
  // Neighbours fall into different groups, in a sequence that no regular pattern of the picture follows.
  static void add_groups(const Picture& picture, const Picture& reference, std::vector<double>& squares) {
    std::array<double, groups> sums{}, counts{};
    const auto off = differences(picture, reference, Space::linear);
    for (std::size_t pixel = 0; 3 * pixel < off.size(); ++pixel) {
      const std::size_t group = mixed(pixel) % groups;
      for (std::size_t c = 0; c < 3; ++c) {
        const double difference = off[3 * pixel + c] / levels_of_full_scale;
        sums[group] += difference * difference;
        counts[group] += 1;
      }
    }
    for (std::size_t group = 0; group < groups; ++group) {
      if (counts[group] > 0) squares.push_back(sums[group] / counts[group]);
    }
  }

  std::size_t replicates_;
};

}  // namespace

const PassDescription convergence_description{
    .name = "convergence",
    .summary = "Error over samples, with the slope of each family of settings, beside what theory says.",
    .source = "Mitchell 1996, Consequences of Stratified Sampling in Graphics, for the slopes of edges",
    .parameters = parameters,
    .quantities = quantities,
};

std::unique_ptr<Metric> make_convergence(const Settings& settings) {
  return std::make_unique<ConvergenceMetric>(settings);
}

}  // namespace moire
