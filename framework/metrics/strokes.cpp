// How lines and circles look as strokes: whether they have their light, and whether it is spread evenly along them.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "metrics/registry.h"

namespace moire {

namespace {

using namespace parameter;

constexpr Parameter parameters[] = {
    real("blur", 1, 0.25, 8, "pixels", "standard deviation of the Gaussian blur through which ripple is seen"),
    real("ends", 8, 0, 1e6, "pixels", "left out of ripple at either end of a line"),
};

constexpr Quantity quantities[] = {
    {.name = "strokes.energy",
     .unit = "",
     .meaning = "ink of the picture over ink of the reference, 1 where all strokes have their light; ink: |pixel - "
                "background| in linear light, summed over pixels and channels",
     .is_judged = false,
     .is_main = true},
    {.name = "strokes.ripple",
     .unit = "",
     .meaning = "(highest - lowest) / mean of the blurred ink along the middle of a stroke, a mean over strokes; low "
                "and high: the least and the most rippled one",
     .is_main = true},
    {.name = "strokes.rmse",
     .unit = "",
     .meaning = "root of the mean square of (ink - ink of the reference) over all pixels that either inks, as a part "
                "of the reference's largest ink",
     .is_main = true},
};

// How far a picture's pixels are from the background.
class Ink {
 public:
  Ink(const Picture& picture, Color background) : size_(picture.size) {
    for (const Color c : picture.pixels) {
      const Color d = c - background;
      values_.push_back(std::abs(double{d.r}) + std::abs(double{d.g}) + std::abs(double{d.b}));
    }
  }

  const std::vector<double>& values() const { return values_; }
  bool has(Point p) const { return p.x >= 0 && p.y >= 0 && p.x < size_.width && p.y < size_.height; }

  // Blurred, at a point: pixels stand at their middles, and their weights are divided by their sum, so that a plain
  // picture stays plain. Beyond five deviations there is less than 1e-6 of a Gaussian.
  double blurred(Point p, double deviation) const {
    const double reach = 5 * deviation;
    double sum = 0, weights = 0;
    for (int y = from(p.y - reach); y < to(p.y + reach, size_.height); ++y) {
      const double down = gaussian(y + 0.5 - p.y, deviation);
      for (int x = from(p.x - reach); x < to(p.x + reach, size_.width); ++x) {
        const double weight = down * gaussian(x + 0.5 - p.x, deviation);
        sum +=
            weight *
            values_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) + static_cast<std::size_t>(x)];
        weights += weight;
      }
    }
    return weights > 0 ? sum / weights : 0;
  }

 private:
  static int from(double place) { return static_cast<int>(std::max(0.0, std::floor(place))); }
  static int to(double place, int size) { return static_cast<int>(std::min<double>(size, std::ceil(place))); }
  static double gaussian(double x, double deviation) { return std::exp(-x * x / (2 * deviation * deviation)); }

  ImageSize size_;
  std::vector<double> values_;
};

// Ripple of each stroke of which enough is in the picture to have any.
class Ripples final : public CurveSink {
 public:
  Ripples(const Ink& ink, double blur, double ends) : ink_(ink), blur_(blur), ends_(ends) {}

  void line(const LineCurve& line) override {
    const double dx = line.to.x - line.from.x, dy = line.to.y - line.from.y, length = std::hypot(dx, dy);
    along(ends_, length - ends_, [&](double s) {
      return Point{line.from.x + s / length * dx, line.from.y + s / length * dy};
    });
  }
  void circle(const CircleCurve& circle) override {
    along(0, 2 * std::numbers::pi * circle.radius, [&](double s) {
      const double angle = s / circle.radius;
      return Point{circle.center.x + circle.radius * std::cos(angle),
                   circle.center.y + circle.radius * std::sin(angle)};
    });
  }

  const std::vector<double>& found() const { return found_; }

 private:
  template <class Place>
  void along(double begin, double end, Place place) {
    constexpr double step = 0.25;  // pixels
    double lowest = std::numeric_limits<double>::infinity(), highest = 0, sum = 0;
    std::size_t count = 0;
    for (double s = begin; s <= end; s += step) {
      const Point p = place(s);
      if (!ink_.has(p)) continue;
      const double ink = ink_.blurred(p, blur_);
      lowest = std::min(lowest, ink);
      highest = std::max(highest, ink);
      sum += ink;
      ++count;
    }
    if (sum > 0) found_.push_back((highest - lowest) * static_cast<double>(count) / sum);
  }

  const Ink& ink_;
  double blur_, ends_;
  std::vector<double> found_;
};

class StrokesMetric final : public Metric {
 public:
  explicit StrokesMetric(const Settings& settings) : blur_(settings.real("blur")), ends_(settings.real("ends")) {}

  std::vector<Measurement> finish(const Judged& judged) override {
    const Curves& curves = *judged.frame->curves();
    const Color background = curves.background_color();
    const Ink own(judged.picture, background), exact(judged.reference, background);
    double ink = 0, exact_ink = 0, largest = 0, squares = 0;
    std::size_t inked = 0;
    for (std::size_t k = 0; k < own.values().size(); ++k) {
      const double a = own.values()[k], b = exact.values()[k];
      ink += a;
      exact_ink += b;
      largest = std::max(largest, b);
      squares += (a - b) * (a - b);
      inked += a > 0 || b > 0 ? 1 : 0;
    }
    std::vector<Measurement> result;
    if (exact_ink > 0) {
      result.push_back({"strokes.energy", ink / exact_ink});
      result.push_back({"strokes.rmse", std::sqrt(squares / static_cast<double>(inked)) / largest});
    }
    Ripples ripples(own, blur_, ends_);
    curves.stream(ripples);
    if (const auto& all = ripples.found(); !all.empty()) {
      double sum = 0;
      for (const double ripple : all) sum += ripple;
      const auto [least, most] = std::minmax_element(all.begin(), all.end());
      result.push_back({"strokes.ripple", sum / static_cast<double>(all.size()), *least, *most});
    }
    return result;
  }

 private:
  double blur_, ends_;
};

}  // namespace

const PassDescription strokes_description{
    .name = "strokes",
    .summary = "Whether lines and circles have their light, and how evenly it lies along them.",
    .source = "Gupta, Sproull 1981 (ropes); Wu 1991",
    .parameters = parameters,
    .quantities = quantities,
    .asks = [](const Settings&) { return Questions::curves; },
};

std::unique_ptr<Metric> make_strokes(const Settings& settings) { return std::make_unique<StrokesMetric>(settings); }

}  // namespace moire
