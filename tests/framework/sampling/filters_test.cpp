// The filters: integrals, transfer functions with known closed forms, the lecture's tables.
#include "sampling/filters.h"

#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

namespace moire::test {

namespace {

constexpr double frequencies[] = {0, 0.01, 0.1, 0.25, 0.5, 0.8125, 1, 1.5, 2.2, 3, 7.7};

// By another rule than the filters' own, between knots and half periods.
double brute_transfer(const Filter& filter, double frequency) {
  double sum = 0, from = 0;
  for (const double knot : filter.knots()) {
    const int parts = 2 + static_cast<int>((knot - from) * 4 * frequency);
    for (int k = 0; k < parts; ++k) {
      const double a = from + (knot - from) * k / parts, b = from + (knot - from) * (k + 1) / parts;
      sum += boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
          [&](double x) { return filter.at(x) * std::cos(2 * std::numbers::pi * frequency * x); }, a, b, 0);
    }
    from = knot;
  }
  return 2 * sum;
}

double sinc(double x) { return x == 0 ? 1 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x); }

std::vector<std::pair<std::string, std::unique_ptr<Filter>>> all() {
  std::vector<std::pair<std::string, std::unique_ptr<Filter>>> result;
  for (const NamedSummary& named : filters()) {
    if (auto filter = make_filter(named.name, {}, 0.25)) result.emplace_back(named.name, std::move(filter));
  }
  for (const double radius : {1e-3, 0.5, 2.5}) result.emplace_back("tent", make_tent(radius));
  for (const double sigma : {1e-3, 0.35, 0.7, 4.0}) result.emplace_back("gaussian", make_gaussian(sigma));
  result.emplace_back("mitchell", make_mitchell(0, 1));
  result.emplace_back("mitchell", make_mitchell(1, 0));
  for (int lobes = 1; lobes <= 8; ++lobes) result.emplace_back("lanczos", make_lanczos(lobes));
  return result;
}

// Keys 1981 and the cubic B-spline, whose mixtures are all of Mitchell's cubics.
double cardinal_transfer(double c, double f) {
  const double w = std::numbers::pi * f;
  return 3 / (w * w) * (sinc(f) * sinc(f) - sinc(2 * f)) -
         c * 2 / (w * w) * (3 * sinc(2 * f) * sinc(2 * f) - 2 * sinc(2 * f) - sinc(4 * f));
}
double mitchell_transfer(double b, double c, double f) {
  if (f == 0) return 1;
  const double spline = std::pow(sinc(f), 4);
  return b == 1 ? spline : b * spline + (1 - b) * cardinal_transfer(c / (1 - b), f);
}

}  // namespace

TEST_CASE("the integral of every filter is 1, and its transfer function is its Fourier transform") {
  for (const auto& [name, filter] : all()) {
    CAPTURE(name, filter->radius());
    CHECK(std::abs(brute_transfer(*filter, 0) - 1) < 1e-13);
    for (const double f : frequencies) {
      CAPTURE(f);
      CHECK(std::abs(filter->transfer(f) - brute_transfer(*filter, f)) < 1e-12);
      CHECK(filter->transfer(-f) == filter->transfer(f));
    }
  }
}

TEST_CASE("every filter is even and ends at its radius, which is its last knot") {
  for (const auto& [name, filter] : all()) {
    CAPTURE(name, filter->radius());
    const double r = filter->radius();
    CHECK(filter->knots().back() == r);
    CHECK(std::is_sorted(filter->knots().begin(), filter->knots().end()));
    CHECK(filter->knots().front() > 0);
    CHECK(filter->at(r) == 0);
    CHECK(filter->at(1.5 * r) == 0);
    for (const double x : {0.1, 0.3, 0.77, 0.99}) CHECK(filter->at(x * r) == filter->at(-x * r));
  }
}

TEST_CASE("box is no filter, and the first of them") {
  CHECK(filters().front().name == "box");
  CHECK(make_filter("box", {}, 1) == nullptr);
}

TEST_CASE("what a tent leaves of a wave is the square of a sinc") {
  for (const double radius : {0.5, 1.0, 2.0}) {
    for (const double f : frequencies)
      CHECK(std::abs(make_tent(radius)->transfer(f) - std::pow(sinc(f * radius), 2)) < 1e-15);
  }
}

TEST_CASE("what Mitchell's cubics leave of a wave is what B-splines and cardinal splines do") {
  const std::pair<double, double> all_bc[] = {{1, 0}, {0, 0.5}, {0, 1}, {1.0 / 3, 1.0 / 3}, {0.7, 0.2}};
  for (const auto& [b, c] : all_bc) {
    const auto filter = make_mitchell(b, c);
    for (const double f : frequencies) {
      CAPTURE(b, c, f);
      // The closed form loses 1e-16 / (pi f)^2.
      CHECK(std::abs(filter->transfer(f) - mitchell_transfer(b, c, f)) < 1e-12);
    }
  }
}

TEST_CASE("Mitchell's filter passes through the values of its paper's family") {
  // The B-spline's 4/6, 1/6; the interpolating ones 1, 0.
  CHECK(std::abs(make_mitchell(1, 0)->at(0) - 4.0 / 6) < 1e-16);
  CHECK(std::abs(make_mitchell(1, 0)->at(1) - 1.0 / 6) < 1e-15);
  CHECK(make_mitchell(0, 0.5)->at(0) == 1);
  CHECK(std::abs(make_mitchell(0, 0.5)->at(1)) < 1e-15);
  // Negative lobes, and no jump between the pieces.
  const auto filter = make_mitchell(1.0 / 3, 1.0 / 3);
  CHECK(filter->at(1.5) < 0);
  CHECK(std::abs(filter->at(std::nextafter(1, 0)) - filter->at(1)) < 1e-14);
  // Translates by whole pixels add up to 1 everywhere.
  for (const double x : {0.0, 0.2, 0.5, 0.9})
    CHECK(std::abs(filter->at(x - 2) + filter->at(x - 1) + filter->at(x) + filter->at(x + 1) - 1) < 1e-14);
}

TEST_CASE(
    "the Gaussian has the 2 that the lecture's formula lacks: it falls to exp(-1/2) at sigma and integrates to 1") {
  for (const double sigma : {0.35, 0.5, 1.0}) {
    const auto filter = make_gaussian(sigma);
    CHECK(std::abs(filter->at(sigma) / filter->at(0) - std::exp(-0.5)) < 1e-15);
    // Without the 2: to exp(-1), and half the integral in two dimensions.
    CHECK(std::abs(filter->at(sigma) / filter->at(0) - std::exp(-1.0)) > 0.2);
    // Cut off at 4 sigma: what lies beyond is 6.3e-5 of it, and so large is the change of any frequency, twice.
    for (const double f : frequencies)
      CHECK(std::abs(filter->transfer(f) - std::exp(-2 * std::pow(std::numbers::pi * f * sigma, 2))) < 1.3e-4);
  }
}

TEST_CASE("Lanczos' filter keeps the middle and is 0 at whole pixels") {
  for (int lobes = 1; lobes <= 8; ++lobes) {
    const auto filter = make_lanczos(lobes);
    CHECK(filter->radius() == lobes);
    for (int k = 1; k < lobes; ++k) CHECK(std::abs(filter->at(k)) < 1e-16);
    const double x = 0.4;
    CHECK(std::abs(filter->at(x) / filter->at(0) - sinc(x) * sinc(x / lobes)) < 1e-15);
  }
}

TEST_CASE("Bartlett windows on their points are the lecture's integer tables") {
  // Maddock, Table 4.1: rows of the upper halves, and the sums of the whole tables.
  const std::array<std::vector<int>, 3> rows{
      {{1, 2, 1, 2, 4, 2},
       {1, 2, 3, 2, 1, 2, 4, 6, 4, 2, 3, 6, 9, 6, 3},
       {1, 2, 3, 4, 3, 2, 1, 2, 4, 6, 8, 6, 4, 2, 3, 6, 9, 12, 9, 6, 3, 4, 8, 12, 16, 12, 8, 4}}};
  const int sums[] = {16, 81, 256};
  for (int t = 0; t < 3; ++t) {
    const int taps = 3 + 2 * t, n = 2 + t, reach = taps / 2;
    const double spacing = 1.0 / n;
    const auto filter = make_filter("bartlett_" + std::to_string(taps), {}, spacing);
    CHECK(is_centred_on_points("bartlett_" + std::to_string(taps)));
    // The integral is 1, so weights times the points' spacing add up to 1.
    const auto entry = [&](int i, int j) {
      return sums[t] * filter->at(i * spacing) * filter->at(j * spacing) * spacing * spacing;
    };
    double sum = 0;
    for (int i = -reach; i <= reach; ++i) {
      for (int j = -reach; j <= reach; ++j) {
        CAPTURE(taps, i, j);
        const int row = j <= 0 ? j + reach : reach - j;
        const int expected = rows[static_cast<std::size_t>(t)][static_cast<std::size_t>(row * taps + i + reach)];
        // Thirds are rounded.
        CHECK(std::abs(entry(i, j) - expected) < 1e-14);
        sum += entry(i, j);
      }
    }
    CHECK(std::abs(sum - sums[t]) < 1e-12);
    CHECK(filter->at((reach + 1) * spacing) < 1e-15);
  }
}

TEST_CASE("only windows of tables are centred on points") {
  for (const NamedSummary& named : filters())
    CHECK(is_centred_on_points(named.name) == named.name.starts_with("bartlett"));
}

}  // namespace moire::test
