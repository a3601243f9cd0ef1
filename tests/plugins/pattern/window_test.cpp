// Weights under filters: quadratures held to closed forms of the box and of an isotropic Gaussian.
#include "weights/window.h"

#include <catch2/catch_test_macros.hpp>
#include <numbers>

#include "numbers.h"
#include "own_filters.h"
#include "sampling/filters.h"
#include "weights/square.h"

namespace moire::test {

namespace {

using pattern::Square;
using pattern::Window;

// The part of a normal distribution below x.
double normal(double x) { return std::erfc(-x / std::numbers::sqrt2) / 2; }

double around(const Window& window, const std::vector<Point>& polygon) {
  double sum = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) sum += window.along(polygon[k], polygon[(k + 1) % polygon.size()]);
  return sum;
}

}  // namespace

TEST_CASE("under a box as a filter, weights are the areas of closed forms") {
  const BoxFilter box;
  const Window window(box);
  Numbers numbers;
  for (int k = 0; k < 300; ++k) {
    const double angle = k < 4 ? k * std::numbers::pi / 8 : numbers.between(0, std::numbers::pi / 2);
    const double a = std::cos(angle), b = std::sin(angle), s = numbers.between(-0.8, 0.8),
                 r = std::exp(numbers.between(-2, 3));
    const Point p{numbers.between(-1, 1), numbers.between(-1, 1)}, q{numbers.between(-1, 1), numbers.between(-1, 1)};
    const Point middle{r * std::cos(7 * angle) + numbers.between(-0.7, 0.7),
                       r * std::sin(7 * angle) + numbers.between(-0.7, 0.7)};
    CAPTURE(angle, s, r, p.x, p.y, q.x, q.y, middle.x, middle.y);
    CHECK(std::abs(window.half_plane(a, b, s) - Square::half_plane(a, b, s)) < 1e-14);
    CHECK(std::abs(window.along(p, q) - Square::along(p, q)) < 1e-14);
    CHECK(std::abs(window.disk(middle, r) - Square::disk(middle, r)) < 1e-14 * (1 + r));
    // A polynomial of 16 terms, each rounded.
    CHECK(std::abs(window.below(s) - Square::below(s)) < 4e-15);
  }
}

TEST_CASE("under an isotropic Gaussian, half-planes are error functions at every angle, disks exponentials") {
  for (const double sigma : {0.2, 0.5, 1.0}) {
    const WideGaussian gaussian(sigma);
    const Window window(gaussian);
    Numbers numbers;
    for (int k = 0; k < 60; ++k) {
      const double angle = k < 8 ? std::pow(10.0, -2 * k) : numbers.between(0, std::numbers::pi / 2);
      const double s = numbers.between(-4, 4) * sigma;
      CAPTURE(sigma, angle, s);
      CHECK(std::abs(window.half_plane(std::cos(angle), std::sin(angle), s) - normal(s / sigma)) < 1e-13);
      const double r = std::abs(s);
      CHECK(std::abs(window.disk({0, 0}, r) - (1 - std::exp(-r * r / (2 * sigma * sigma)))) < 1e-13);
      // A square turned about the middle holds as much as an upright one.
      const Point u{r * std::cos(angle), r * std::sin(angle)}, v{-u.y, u.x};
      const double side = normal(r / sigma / std::numbers::sqrt2) - normal(-r / sigma / std::numbers::sqrt2);
      CHECK(std::abs(around(window, {u, v, {-u.x, -u.y}, {-v.x, -v.y}}) - side * side) < 1e-13);
    }
  }
}

TEST_CASE("of every filter, what is below its end is all, and parts add up to the whole") {
  for (const NamedSummary& named : filters()) {
    const auto filter = make_filter(named.name, Settings(named.parameters), 0.25);
    if (!filter) continue;
    CAPTURE(named.name);
    const Window window(*filter);
    const double r = window.radius();
    CHECK(std::abs(window.below(std::nextafter(r, 0)) - 1) < 1e-12);
    Numbers numbers;
    for (int k = 0; k < 20; ++k) {
      const double angle = numbers.between(0, std::numbers::pi / 2), a = std::cos(angle), b = std::sin(angle);
      const double s = numbers.between(-1, 1) * r;
      CAPTURE(angle, s);
      CHECK(std::abs(window.half_plane(a, b, s) + window.half_plane(a, b, -s) - 1) < 1e-12);
      // The half-plane as a large polygon, and a disk so large that its edge is straight to 2 r^2 / 1e9.
      const Point n{a, b}, t{-b, a};
      const auto corner = [&](double along, double across) {
        return Point{along * n.x + across * t.x, along * n.y + across * t.y};
      };
      const double half = window.half_plane(a, b, s), far = 8 * r;
      CHECK(std::abs(around(window, {corner(-s, -far), corner(far, -far), corner(far, far), corner(-s, far)}) - half) <
            1e-12);
      CHECK(std::abs(window.disk(corner(1e9 - s, 0), 1e9) - half) < 1e-6);
      // Cut at y = 0 and at x = 0.
      const Point o{0, 0}, p{numbers.between(-r, r), numbers.between(-r, r)};
      CHECK(std::abs(window.along(o, p) + window.along(p, o)) < 1e-13);
    }
  }
}

}  // namespace moire::test
