// Alias, blur and noise: what a method makes of known frequencies, and how much of its error stands still.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

#include "metrics/gains.h"
#include "metrics/power.h"
#include "metrics/registry.h"

namespace moire {

namespace {

using namespace parameter;

constexpr Parameter parameters[] = {
    integer("pairs", 1, 1, 1000, "pairs",
            "pairs of pictures with independent random numbers, for methods that draw any; intervals take two or more"),
    integer("rings", 32, 2, 4096, "", "rings of the radial power spectrum"),
};

constexpr Quantity quantities[] = {
    {.name = "spectrum.alias",
     .unit = "",
     .meaning = "of sinusoids: sum over those above half a cycle a pixel of a^2 Re(T_A conj T_B) / sum a^2, T the "
                "complex gain of a component where it folds to, A and B two pictures with independent random numbers "
                "(of methods without any: twice the same). 1 is point sampling. Of a zone plate: covariance of A and "
                "B where the frequency is above .55, over a^2 / 2",
     .is_main = true},
    {.name = "spectrum.blur",
     .unit = "",
     .meaning = "of sinusoids: 1 - sum over those below half a cycle a pixel of a^2 Re(T_A + T_B) / 2 / sum a^2; below "
                "0: sharpened. Of a zone plate: 1 - the slope of the pixels on what is seen at their middles, where "
                "the frequency is below .45",
     .is_main = true},
    {.name = "spectrum.noise",
     .unit = "",
     .meaning = "mean of (A - B)^2 / 2 over the power of the pattern (sum a^2 / 2): what changes with the random "
                "numbers",
     .is_main = true},
    {.name = "spectrum.shift",
     .unit = "pixels",
     .meaning = "root mean square of arg T / (2 pi |f|) over the components below half a cycle a pixel, weighed by "
                "a^2: how far they are moved, which blur counts as loss"},
    {.name = "spectrum.structured",
     .unit = "levels",
     .meaning = "root of the mean of (A - R)(B - R), R the reference, in linear light: the part of the error that is "
                "the same whatever the random numbers; its square and that of random_error make up the mean square "
                "error. Below 0: the root of the negative, which is noise"},
    {.name = "spectrum.random_error",
     .unit = "levels",
     .meaning = "root of the mean of (A - B)^2 / 2, in linear light: the part of the error that is noise"},
    {.name = "spectrum.peak",
     .unit = "cycles per pixel",
     .meaning = "frequency of the largest bin of the picture's power spectrum, the constant aside",
     .is_judged = false},
    {.name = "spectrum.predicted_peak",
     .unit = "cycles per pixel",
     .meaning = "frequency to which the strongest component of the pattern folds when it is sampled at points",
     .is_judged = false},
};

constexpr CurveDescription curve_descriptions[] = {
    {"spectrum.error_power", "Power of the error by frequency", "cycles a pixel", "mean power, linear light"},
};

// The parts of the band that a zone plate is judged by: well below and well above half a cycle a pixel.
constexpr double in_band_end = 0.45, out_of_band_begin = 0.55;

// Of the mean of a pixel's channels, in linear light.
std::vector<double> greys(const Picture& picture) {
  std::vector<double> result;
  for (const Color& c : picture.pixels) result.push_back((static_cast<double>(c.r) + c.g + c.b) / 3);
  return result;
}

// Means over pixels and channels of products of differences, in levels squared.
struct Parts {
  double structured, random;
};

Parts parts_of(const Picture& a, const Picture& b, const Picture& reference) {
  const auto of_a = differences(a, reference, Space::linear), of_b = differences(b, reference, Space::linear);
  Parts parts{};
  for (std::size_t k = 0; k < of_a.size(); ++k) {
    parts.structured += of_a[k] * of_b[k];
    parts.random += (of_a[k] - of_b[k]) * (of_a[k] - of_b[k]) / 2;
  }
  const auto count = static_cast<double>(of_a.size());
  return {parts.structured / count, parts.random / count};
}

double signed_root(double square) { return std::copysign(std::sqrt(std::abs(square)), square); }

double covariance(const std::vector<double>& a, const std::vector<double>& b) {
  double mean_a = 0, mean_b = 0, sum = 0;
  const auto count = static_cast<double>(a.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    mean_a += a[k] / count;
    mean_b += b[k] / count;
  }
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - mean_a) * (b[k] - mean_b);
  return sum / count;
}

struct Numbers {
  double alias = std::nan(""), blur = std::nan(""), noise = std::nan(""), shift = std::nan("");
};

double ratio(double part, double whole) { return whole > 0 ? part / whole : std::nan(""); }

Numbers of_sinusoids(std::span<const Sinusoid> waves, const Picture& a, const Picture& b, double random) {
  const auto ta = gains(a, waves), tb = gains(b, waves);
  if (ta.empty()) return {};
  double inside = 0, outside = 0, kept = 0, folded_in = 0, moved = 0;
  for (std::size_t k = 0; k < waves.size(); ++k) {
    const double power = waves[k].amplitude * waves[k].amplitude;
    if (is_in_band(waves[k])) {
      inside += power;
      kept += power * (ta[k] + tb[k]).real() / 2;
      const double by = std::arg(ta[k] + tb[k]) / (2 * std::numbers::pi * std::hypot(waves[k].fx, waves[k].fy));
      moved += power * by * by;
    } else {
      outside += power;
      folded_in += power * (ta[k] * std::conj(tb[k])).real();
    }
  }
  const double scale = levels_of_full_scale * levels_of_full_scale;
  return {ratio(folded_in, outside), 1 - ratio(kept, inside), ratio(random / scale, (inside + outside) / 2),
          std::sqrt(ratio(moved, inside))};
}

// The frequency at each pixel's middle and what is seen there.
struct ZonePlate {
  std::vector<double> frequencies, centres;
  double amplitude;
};

std::optional<ZonePlate> zone_plate_of(const Frame& frame, const Spectrum& spectrum) {
  const ImageSize size = frame.size();
  std::vector<SamplePoint> points;
  ZonePlate plate{{}, {}, spectrum.amplitude()};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      points.push_back({x + 0.5, y + 0.5});
      plate.frequencies.push_back(spectrum.local_frequency({x + 0.5, y + 0.5}));
    }
  }
  if (std::isnan(plate.frequencies.front())) return std::nullopt;
  std::vector<Hit> hits(points.size());
  Counters counters;
  frame.trace(points, hits, counters);
  for (const Hit& hit : hits)
    plate.centres.push_back((static_cast<double>(hit.color.r) + hit.color.g + hit.color.b) / 3);
  return plate;
}

Numbers of_zone_plate(const ZonePlate& plate, const Picture& a, const Picture& b, double random) {
  const auto of_a = greys(a), of_b = greys(b);
  std::vector<double> inside_mean, inside_centre, outside_a, outside_b;
  for (std::size_t k = 0; k < of_a.size(); ++k) {
    if (plate.frequencies[k] < in_band_end) {
      inside_mean.push_back((of_a[k] + of_b[k]) / 2);
      inside_centre.push_back(plate.centres[k]);
    } else if (plate.frequencies[k] > out_of_band_begin) {
      outside_a.push_back(of_a[k]);
      outside_b.push_back(of_b[k]);
    }
  }
  const double power = plate.amplitude * plate.amplitude / 2;
  Numbers numbers;
  if (!outside_a.empty()) numbers.alias = covariance(outside_a, outside_b) / power;
  if (!inside_mean.empty())
    numbers.blur = 1 - ratio(covariance(inside_mean, inside_centre), covariance(inside_centre, inside_centre));
  numbers.noise = random / (levels_of_full_scale * levels_of_full_scale) / power;
  return numbers;
}

double peak_of(const Picture& picture) {
  const auto power = power_spectrum(greys(picture), picture.size);
  if (power.size() < 2) return std::nan("");
  const auto bin = static_cast<std::size_t>(std::max_element(power.begin() + 1, power.end()) - power.begin());
  const auto width = static_cast<std::size_t>(picture.size.width);
  return std::hypot(folded(static_cast<double>(bin % width) / picture.size.width),
                    folded(static_cast<double>(bin / width) / picture.size.height));
}

class SpectrumMetric final : public Metric {
 public:
  explicit SpectrumMetric(const Settings& settings)
      : pairs_(static_cast<std::size_t>(settings.integer("pairs"))),
        rings_(static_cast<int>(settings.integer("rings"))) {}

  std::size_t replicates() const override { return 2 * pairs_; }

  std::vector<Measurement> finish(const Judged& judged) override {
    const Spectrum* const spectrum = judged.frame ? judged.frame->spectrum() : nullptr;
    const std::span<const Sinusoid> waves = spectrum ? spectrum->sinusoids() : std::span<const Sinusoid>();
    std::optional<ZonePlate> plate;
    if (spectrum && waves.empty()) plate = zone_plate_of(*judged.frame, *spectrum);

    std::array<std::vector<double>, 6> found;
    const auto judge = [&](const Picture& a, const Picture& b) {
      const Parts parts = parts_of(a, b, judged.reference);
      Numbers numbers;
      if (!waves.empty()) numbers = of_sinusoids(waves, a, b, parts.random);
      if (plate) numbers = of_zone_plate(*plate, a, b, parts.random);
      const double all[] = {numbers.alias, numbers.blur, numbers.noise, numbers.shift, parts.structured, parts.random};
      for (std::size_t q = 0; q < found.size(); ++q) found[q].push_back(all[q]);
    };
    if (judged.replicates.empty()) {
      judge(judged.picture, judged.picture);
    } else {
      for (std::size_t p = 0; p < pairs_; ++p) judge(judged.replicates[2 * p], judged.replicates[2 * p + 1]);
    }

    std::vector<Measurement> result;
    for (std::size_t q = 0; q < found.size(); ++q) {
      Measurement m = mean_of(quantities[q].name, found[q]);
      if (!is_defined(q, waves, plate.has_value())) continue;
      if (q >= 4) {
        for (double* value : {&m.value, &m.low, &m.high}) *value = signed_root(*value);
      }
      result.push_back(m);
    }
    if (!waves.empty()) {
      const Sinusoid& strongest = *std::max_element(
          waves.begin(), waves.end(), [](const Sinusoid& p, const Sinusoid& q) { return p.amplitude < q.amplitude; });
      result.push_back({"spectrum.peak", peak_of(judged.picture)});
      result.push_back({"spectrum.predicted_peak", std::hypot(folded(strongest.fx), folded(strongest.fy))});
    }
    trace_error(judged);
    return result;
  }

  std::vector<Curve> curves() const override { return {{curve_descriptions[0].name, error_power_}}; }

 private:
  // Alias takes components above half a cycle a pixel, blur and shift some below; of a zone plate there is no shift.
  static bool is_defined(std::size_t quantity, std::span<const Sinusoid> waves, bool is_zone_plate) {
    const auto inside = static_cast<std::size_t>(std::count_if(waves.begin(), waves.end(), is_in_band));
    if (quantity >= 4) return true;
    if (is_zone_plate) return quantity != 3;
    if (quantity == 2) return !waves.empty();
    return quantity == 0 ? inside < waves.size() : inside > 0;
  }

  // The mean, and 95 % of its own distribution where there is more than one pair.
  static Measurement mean_of(std::string_view name, const std::vector<double>& values) {
    const auto count = static_cast<double>(values.size());
    double mean = 0, square = 0;
    for (double value : values) mean += value / count;
    for (double value : values) square += (value - mean) * (value - mean);
    if (values.size() < 2) return {name, mean};
    const double margin = 1.96 * std::sqrt(square / (count - 1) / count);
    return {name, mean, mean - margin, mean + margin};
  }

  void trace_error(const Judged& judged) {
    std::vector<double> error = greys(judged.picture);
    const std::vector<double> reference = greys(judged.reference);
    for (std::size_t k = 0; k < error.size(); ++k) error[k] -= reference[k];
    error_power_ = radial_mean(power_spectrum(error, judged.picture.size), judged.picture.size, rings_);
    // What is not above 0 has no place on a logarithmic axis.
    std::erase_if(error_power_, [](const Point& p) { return !(p.y > 0); });
  }

  std::size_t pairs_;
  int rings_;
  std::vector<Point> error_power_;
};

}  // namespace

const PassDescription spectrum_description{
    .name = "spectrum",
    .summary = "Alias, blur and noise on patterns of known frequencies; structured error and noise anywhere.",
    .source = "Maddock, Lecture 11, section 2; the definitions are ours",
    .parameters = parameters,
    .quantities = quantities,
    .curves = curve_descriptions,
};

std::unique_ptr<Metric> make_spectrum(const Settings& settings) { return std::make_unique<SpectrumMetric>(settings); }

}  // namespace moire
