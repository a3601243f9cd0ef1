// The averages that blobs and zone plates are products of, against double-exponential quadrature and Fresnel's series.
#include "kinds/factors.h"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <catch2/catch_test_macros.hpp>

#include "numbers.h"
#include "own_filters.h"
#include "sampling/filters.h"

namespace moire::test {

namespace {

double quadrature(const std::function<double(double)>& f, double a, double b) {
  static boost::math::quadrature::tanh_sinh<double> rule;
  return rule.integrate(f, a, b, 1e-15);
}

// The integral from 0 to x of e^(i pi rate t^2), by its series: for phases so small that no term is large.
std::complex<long double> fresnel(long double rate, long double x) {
  const std::complex<long double> step(0, std::numbers::pi_v<long double> * rate * x * x);
  std::complex<long double> term = x, sum = 0;
  for (int n = 0; n < 200; ++n) {
    sum += term / (2.0L * n + 1);
    term *= step / (n + 1.0L);
  }
  return sum;
}

}  // namespace

TEST_CASE("the average of a Gaussian over a pixel is right to rounding") {
  Numbers numbers;
  for (const double sigma : {0.02, 0.3, 1.5, 10.0, 1000.0}) {
    const pattern::Gaussian gaussian(sigma);
    for (int k = 0; k < 50; ++k) {
      const double x = numbers.between(-1, 1) * (3 * sigma + 0.5);
      CAPTURE(sigma, x);
      // Two error functions near 1, each rounded by 1 or 2 times 1e-16, times sigma sqrt(pi / 2).
      // Where it peaks inside, quadrature needs the peak as an end.
      const double peak = std::clamp(0.0, x - 0.5, x + 0.5);
      const auto f = [&](double t) { return gaussian.at(t); };
      CHECK(std::abs(gaussian.over_pixel(x) - (quadrature(f, x - 0.5, peak) + quadrature(f, peak, x + 0.5))) <
            2e-14 + 6e-16 * sigma);
    }
  }
}

TEST_CASE("the average of a chirp over a pixel is Fresnel's integral") {
  Numbers numbers;
  for (const double rate : {1e-3, 0.02, 0.3, 2.0}) {
    const pattern::Chirp chirp(rate);
    for (int k = 0; k < 50; ++k) {
      // Phases up to 12: terms of the series up to e^12, of which 64 bits keep 1e-14.
      const double x = numbers.between(-1, 1) * (std::sqrt(12 / (std::numbers::pi * rate)) - 0.5);
      CAPTURE(rate, x);
      const std::complex<long double> exact = fresnel(rate, x + 0.5L) - fresnel(rate, x - 0.5L);
      CHECK(std::abs(chirp.over_pixel(x) - std::complex<double>(exact)) < 1e-13);
    }
  }
}

TEST_CASE("far out, at up to 16 cycles a pixel, halves of a pixel hold what the pixel holds") {
  for (const double frequency : {0.5, 3.0, 16.0}) {
    const double rate = 0.05, x = frequency / rate;
    // The same plate at twice the size.
    const pattern::Chirp chirp(rate), twice(rate / 4);
    const std::complex<double> halves = 0.5 * (twice.over_pixel(2 * x - 0.5) + twice.over_pixel(2 * x + 0.5));
    CAPTURE(frequency);
    // Phases of pi rate x^2 are rounded by 1e-16 of them.
    CHECK(std::abs(chirp.over_pixel(x) - halves) < 1e-15 * std::numbers::pi * rate * x * x + 1e-14);
  }
}

TEST_CASE("under every filter, averages of a Gaussian and of a chirp are those of another quadrature") {
  std::vector<std::unique_ptr<Filter>> all;
  all.push_back(std::make_unique<BoxFilter>());
  for (const NamedSummary& named : filters()) {
    if (auto filter = make_filter(named.name, Settings(named.parameters), 0.25)) all.push_back(std::move(filter));
  }
  Numbers numbers;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const pattern::Window window(*all[k]);
    for (int trial = 0; trial < 6; ++trial) {
      const pattern::Gaussian gaussian(std::exp(numbers.between(-2, 2)));
      const pattern::Chirp chirp(0.05);
      const double x = numbers.between(-5, 5);
      const auto average = [&](const std::function<double(double)>& f) {
        double sum = 0, from = 0;
        for (const double knot : all[k]->knots()) {
          // Eighths: double-exponential rules dislike waves.
          for (int i = 0; i < 8; ++i) {
            const double a = from + (knot - from) * i / 8, b = from + (knot - from) * (i + 1) / 8;
            sum += quadrature([&](double t) { return all[k]->at(t) * (f(x + t) + f(x - t)); }, a, b);
          }
          from = knot;
        }
        return sum;
      };
      CAPTURE(k, trial, x);
      CHECK(std::abs(gaussian.under(window, x) - average([&](double t) { return gaussian.at(t); })) < 1e-12);
      CHECK(std::abs(chirp.under(window, x).real() - average([&](double t) { return chirp.at(t).real(); })) < 1e-12);
      CHECK(std::abs(chirp.under(window, x).imag() - average([&](double t) { return chirp.at(t).imag(); })) < 1e-12);
    }
  }
}

}  // namespace moire::test
