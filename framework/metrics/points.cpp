// How evenly a pattern's points lie: discrepancy and power spectrum, whatever the scene.
#include <algorithm>
#include <cmath>

#include "metrics/point_set.h"
#include "metrics/registry.h"

namespace moire {

namespace {

using namespace parameter;

constexpr Parameter parameters[] = {
    integer("pixels", 64, 1, 65536, "pixels", "pixels whose points are looked at: a square of them"),
    integer("reach", 0, 0, 256, "cycles per pixel",
            "highest frequency of the power spectrum; 0: three times the root of the number of points, at most 48"),
};

constexpr Quantity quantities[] = {
    {.name = "points.count", .unit = "per pixel", .meaning = "points of a pixel, a mean", .is_judged = false},
    {.name = "points.discrepancy",
     .unit = "",
     .meaning = "L2 star discrepancy of a pixel's points (Warnock 1972), a mean over pixels; low and high: the lowest "
                "and the highest"},
};

constexpr CurveDescription curve_descriptions[] = {
    {"points.power", "Power spectrum of the points of a pixel", "cycles a pixel", "power (random points: 1)"},
};

constexpr int farthest = 48;

class PointsMetric final : public Metric {
 public:
  explicit PointsMetric(const Settings& settings)
      : side_(std::max(1, static_cast<int>(std::lround(std::sqrt(static_cast<double>(settings.integer("pixels"))))))),
        reach_(static_cast<int>(settings.integer("reach"))) {}

  std::vector<Measurement> finish(const Judged& judged) override {
    if (!judged.points) return {};
    std::vector<double> discrepancies;
    double count = 0;
    for (int y = 0; y < side_; ++y) {
      for (int x = 0; x < side_; ++x) {
        const std::vector<Point> points = points_of(*judged.points, {x, y, 0, judged.seed});
        discrepancies.push_back(star_discrepancy(points));
        count += static_cast<double>(points.size());
        add_power(points);
      }
    }
    const auto pixels = static_cast<double>(discrepancies.size());
    double sum = 0;
    for (double d : discrepancies) sum += d;
    for (Point& p : power_) p.y /= pixels;
    // What a pattern has nothing of has no place on a logarithmic axis.
    std::erase_if(power_, [](const Point& p) { return !(p.y > 1e-12); });
    const auto [lowest, highest] = std::minmax_element(discrepancies.begin(), discrepancies.end());
    return {{"points.count", count / pixels}, {"points.discrepancy", sum / pixels, *lowest, *highest}};
  }

  std::vector<Curve> curves() const override {
    if (power_.empty()) return {};
    return {{curve_descriptions[0].name, power_}};
  }

 private:
  static std::vector<Point> points_of(const PointSampler& sampler, const Pixel& pixel) {
    Points points;
    sampler.points(pixel, points);
    std::vector<Point> result;
    for (const Points::Entry& entry : points.entries()) result.push_back({entry.x, entry.y});
    return result;
  }

  void add_power(const std::vector<Point>& points) {
    if (reach_ == 0)
      reach_ = std::min(farthest, static_cast<int>(std::ceil(3 * std::sqrt(static_cast<double>(points.size())))));
    const auto own = point_power(points, reach_);
    if (power_.empty()) {
      power_ = own;
    } else {
      for (std::size_t k = 0; k < own.size(); ++k) power_[k].y += own[k].y;
    }
  }

  int side_, reach_;
  std::vector<Point> power_;
};

}  // namespace

const PassDescription points_description{
    .name = "points",
    .summary = "How evenly the points of a pattern lie: discrepancy and power spectrum.",
    .source = "Warnock 1972 (discrepancy)",
    .parameters = parameters,
    .quantities = quantities,
    .curves = curve_descriptions,
};

std::unique_ptr<Metric> make_points(const Settings& settings) { return std::make_unique<PointsMetric>(settings); }

}  // namespace moire
