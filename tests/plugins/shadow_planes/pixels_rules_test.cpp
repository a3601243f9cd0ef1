// Rules that average over outlines and tiles, held to polynomials.
#include <cmath>
#include <random>

#include "light/triangle_rule.h"
#include "pixels/outline_moments.h"
#include "pixels/tile_rule.h"

using namespace shadow_planes;

namespace {

// The mean of a polynomial of degree 5 or less over a convex outline, triangle by triangle.
template <class Function>
double mean_over(const Outline& outline, Function function) {
  double sum = 0, area = 0;
  for (std::size_t k = 2; k < outline.size(); ++k) {
    const moire::Point &a = outline[0], &b = outline[k - 1], &c = outline[k];
    const double twice = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    area += twice;
    for (const TrianglePoint& at : seven_points) {
      sum += twice * at.weight * function(at.a * a.x + at.b * b.x + at.c * c.x, at.a * a.y + at.b * b.y + at.c * c.y);
    }
  }
  return sum / area;
}

}  // namespace

TEST_CASE("seven points of a triangle are exact to degree 5", "[shadow_planes]") {
  // Over the triangle (0, 0), (1, 0), (0, 1) the mean of x^i y^j is 2 i! j! / (i + j + 2)!.
  const Outline unit{{0, 0}, {1, 0}, {0, 1}};
  for (int i = 0; i <= 5; ++i) {
    for (int j = 0; i + j <= 5; ++j) {
      const double mean = 2 * std::tgamma(i + 1) * std::tgamma(j + 1) / std::tgamma(i + j + 3);
      const auto power = [&](double x, double y) { return std::pow(x, i) * std::pow(y, j); };
      CHECK(std::abs(mean_over(unit, power) - mean) <= 1e-15);
    }
  }
  CHECK(std::abs(mean_over(unit, [](double x, double) { return std::pow(x, 6); }) - 1.0 / 28) > 1e-5);
}

TEST_CASE("moments of outlines are those of rules over their triangles", "[shadow_planes]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 200; ++trial) {
    // Corners on an ellipse far from the origin, three to eight.
    const std::size_t count = 3 + static_cast<std::size_t>(trial) % 6;
    std::vector<double> angles;
    for (std::size_t k = 0; k < count; ++k) angles.push_back(6.28 * unit(random));
    std::sort(angles.begin(), angles.end());
    const double flat = std::pow(10, -3 * unit(random)), slope = unit(random);
    Outline outline;
    for (const double angle : angles) {
      outline.push_back({300 + 0.5 * std::cos(angle), 200 + 0.5 * (slope * std::cos(angle) + flat * std::sin(angle))});
    }
    if (doubled_area(outline) < 1e-4) continue;
    const OutlineMoments m = moments_of(outline);
    const auto in_uv = [&](auto function) {
      return mean_over(outline, [&](double x, double y) {
        const double u = (x - m.centroid.x) / m.xu;
        return function(u, (y - m.centroid.y - m.yu * u) / m.yv);
      });
    };
    // Coordinates of hundreds, and shapes as flat as 1e-3, leave some ten digits.
    constexpr double near = 1e-8;
    CHECK(std::abs(m.area - 0.5 * doubled_area(outline)) <= 1e-15);
    CHECK(std::abs(in_uv([](double u, double) { return u; })) <= near);
    CHECK(std::abs(in_uv([](double, double v) { return v; })) <= near);
    CHECK(std::abs(in_uv([](double u, double) { return u * u; }) - 1) <= near);
    CHECK(std::abs(in_uv([](double u, double v) { return u * v; })) <= near);
    CHECK(std::abs(in_uv([](double, double v) { return v * v; }) - 1) <= near);
    CHECK(std::abs(in_uv([](double u, double v) { return u * (u * u + v * v); }) - m.cos1) <= near);
    CHECK(std::abs(in_uv([](double u, double v) { return v * (u * u + v * v); }) - m.sin1) <= near);
    CHECK(std::abs(in_uv([](double u, double v) { return u * (u * u - 3 * v * v); }) - m.cos3) <= near);
    CHECK(std::abs(in_uv([](double u, double v) { return v * (3 * u * u - v * v); }) - m.sin3) <= near);
    // All points that rules use, up to sqrt 2 from the centroid, are within the outline.
    for (int k = 0; k < 24; ++k) {
      const double angle = 0.2618 * k;
      const moire::Point p = m.at(std::sqrt(2.0) * std::cos(angle), std::sqrt(2.0) * std::sin(angle));
      for (std::size_t c = 0; c < count; ++c) CHECK(edge_line(outline[c], outline[(c + 1) % count])(p) > -1e-9);
    }
  }
}

TEST_CASE("tiles average the polynomials that their points determine", "[shadow_planes]") {
  for (const int side : {2, 4, 8, 16}) {
    const TileRule& rule = tile_rule(side);
    const int n = rule.points();
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        std::vector<double> values, averages(static_cast<std::size_t>(side * side));
        for (int b = 0; b < n; ++b) {
          for (int a = 0; a < n; ++a) values.push_back(std::pow(rule.at(a) / side, i) * std::pow(rule.at(b) / side, j));
        }
        rule.averages(values, averages);
        const auto mean = [&](int pixel, int power) {
          const double from = static_cast<double>(pixel) / side, to = static_cast<double>(pixel + 1) / side;
          return (std::pow(to, power + 1) - std::pow(from, power + 1)) / (power + 1) * side;
        };
        for (int y = 0; y < side; ++y) {
          for (int x = 0; x < side; ++x) {
            REQUIRE(std::abs(averages[static_cast<std::size_t>(y * side + x)] - mean(x, i) * mean(y, j)) <= 1e-14);
          }
        }
      }
    }
  }
}

TEST_CASE("a tile's estimate is not below its error", "[shadow_planes]") {
  const auto check = [](int side, auto function, bool is_smooth) {
    const TileRule& rule = tile_rule(side);
    const int n = rule.points();
    std::vector<double> values, averages(static_cast<std::size_t>(side * side));
    for (int b = 0; b < n; ++b) {
      for (int a = 0; a < n; ++a) values.push_back(function(rule.at(a) / side, rule.at(b) / side));
    }
    rule.averages(values, averages);
    double worst = 0;
    constexpr int fine = 64;
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        double sum = 0;
        for (int k = 0; k < fine * fine; ++k) {
          const double at_x = x + (k % fine + 0.5) / fine, at_y = y + (k / fine + 0.5) / fine;
          sum += function(at_x / side, at_y / side);
        }
        worst = std::max(worst, std::abs(sum / (fine * fine) - averages[static_cast<std::size_t>(y * side + x)]));
      }
    }
    INFO(side);
    CHECK(worst <= rule.error(values, is_smooth) + 2e-5 / (side * side));  // that of 64 x 64 points
  };
  for (const int side : {2, 4, 8, 16}) {
    for (const double wave : {0.3, 1.0, 3.0}) {
      check(
          side, [&](double x, double y) { return std::sin(wave * (x + 0.7 * y) + 0.4); }, true);
      check(
          side, [&](double x, double y) { return 1 / (1 + wave * wave * (x * x + y)); }, true);
    }
    // A function that bends along a line.
    for (const double at : {0.2, 0.45, 0.8}) {
      check(
          side,
          [&](double x, double y) {
            const double beyond = std::max(0.0, x + 0.3 * y - at);
            return beyond * beyond;
          },
          false);
    }
  }
}
