#include "metrics/cost_model.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <algorithm>
#include <cmath>

#include <moire/error.h>
#include <moire/random.h>

#include "message_of.h"

namespace moire::test {
namespace {

constexpr OperationCounts truth{4.5, 60, 8, 2.25, 3.5};

// Runs over views and rates as they come: L and P belong to the view, M and hits to the rate; all by points.
// `noise`: relative.
std::vector<CostSample> runs(int views, int rates, double noise) {
  std::vector<CostSample> samples;
  for (int v = 0; v < views; ++v) {
    const double steps = 800.0 * (v + 1), pixels = 400 - 15.0 * v;
    for (int r = 0; r < rates; ++r) {
      const double hits = pixels * (1 << r), sampled = steps * (1 - std::exp(-hits / steps));
      CostSample sample{
          "view " + std::to_string(v), "SS" + std::to_string(1 << r), {steps, pixels, sampled, hits, 0}, 0};
      for (std::size_t k = 0; k < truth.size(); ++k) sample.time += truth[k] * sample.counts[k];
      sample.time *= 1 + noise * (2 * random({v, r, 0, 7}, 0, 0) - 1);
      samples.push_back(sample);
    }
  }
  return samples;
}

// One run by lines in each view: every voxel is sampled, a run each and one more for every pixel.
std::vector<CostSample> with_lines(std::vector<CostSample> samples) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].sampler != "SS1") continue;
    const double steps = samples[i].counts[0], pixels = samples[i].counts[1];
    CostSample lines{samples[i].scene, "AS", {steps, pixels, 0.9 * steps, 0, 0.9 * steps + pixels - 1}, 0};
    for (std::size_t k = 0; k < truth.size(); ++k) lines.time += truth[k] * lines.counts[k];
    samples.push_back(lines);
  }
  return samples;
}

TEST_CASE("runs that obey the cost model give its coefficients back") {
  const CostModel model = fit_cost_model(with_lines(runs(3, 6, 0)));
  for (std::size_t k = 0; k < truth.size(); ++k) {
    CAPTURE(k);
    REQUIRE(model.coefficients[k]);
    CHECK_THAT(model.coefficients[k]->value, Catch::Matchers::WithinRel(truth[k], 1e-9));
    CHECK(model.coefficients[k]->low <= model.coefficients[k]->value);
    CHECK(model.coefficients[k]->high >= model.coefficients[k]->value);
  }
  CHECK_THAT(model.predict({1000, 400, 300, 800, 0}),
             Catch::Matchers::WithinRel(4.5 * 1000 + 60 * 400 + 8 * 300 + 1800, 1e-9));
}

// The normal equations of the relative errors, solved by Cramer's rule in long double.
std::array<long double, 4> by_cramer(const std::vector<CostSample>& samples) {
  long double a[4][5] = {};
  for (const CostSample& s : samples) {
    for (std::size_t i = 0; i < 4; ++i) {
      const long double x = s.counts[i] / static_cast<long double>(s.time);
      for (std::size_t j = 0; j < 4; ++j) a[i][j] += x * (s.counts[j] / static_cast<long double>(s.time));
      a[i][4] += x;
    }
  }
  // The determinant of the columns `c`, by permutations.
  const auto determinant = [&](std::array<std::size_t, 4> c) {
    std::array<std::size_t, 4> p{0, 1, 2, 3};
    long double sum = 0;
    do {
      int inversions = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = i + 1; j < 4; ++j) inversions += p[i] > p[j];
      }
      long double product = inversions % 2 == 0 ? 1 : -1;
      for (std::size_t i = 0; i < 4; ++i) product *= a[i][c[p[i]]];
      sum += product;
    } while (std::next_permutation(p.begin(), p.end()));
    return sum;
  };
  std::array<long double, 4> solution{};
  for (std::size_t k = 0; k < 4; ++k) {
    std::array<std::size_t, 4> columns{0, 1, 2, 3};
    columns[k] = 4;
    solution[k] = determinant(columns) / determinant({0, 1, 2, 3});
  }
  return solution;
}

TEST_CASE("the fit is that of the normal equations, and its intervals hold the truth about as often as they say") {
  const auto samples = runs(4, 6, 0.1);
  const auto expected = by_cramer(samples);
  const CostModel model = fit_cost_model(samples);
  CHECK_FALSE(model.coefficients[4]);  // no lines, so no cost of theirs
  for (std::size_t k = 0; k < 4; ++k) {
    CAPTURE(k);
    CHECK_THAT(model.coefficients[k]->value, Catch::Matchers::WithinRel(static_cast<double>(expected[k]), 1e-7));
  }
  // Noise of another seed each time. 400 intervals of 95 %: 380 are expected, 4.4 is the deviation of their number for
  // normal noise; 350 is 7 deviations below. Uniform noise has no tails and does better.
  int held = 0;
  for (int trial = 0; trial < 100; ++trial) {
    auto noisy = runs(4, 6, 0);
    for (std::size_t i = 0; i < noisy.size(); ++i)
      noisy[i].time *= 1 + 0.1 * (2 * random({trial, static_cast<int>(i), 1, 3}, 0, 0) - 1);
    const CostModel fit = fit_cost_model(noisy);
    for (std::size_t k = 0; k < 4; ++k)
      held += fit.coefficients[k]->low <= truth[k] && truth[k] <= fit.coefficients[k]->high;
  }
  CHECK(held >= 350);
  CHECK(held < 400);
}

TEST_CASE("a scene that the model was not fitted to is predicted, well if it obeys the model and badly if not") {
  auto samples = runs(4, 6, 0);
  for (const HeldOut& h : predict_held_out(samples)) {
    CHECK(h.median < 1e-9);
    CHECK(h.worst < 1e-9);
  }
  for (CostSample& s : samples) s.time *= s.scene == "view 2" ? 2 : 1;
  const auto held_out = predict_held_out(samples);
  REQUIRE(held_out.size() == 4);
  CHECK(held_out[2].scene == "view 2");
  CHECK_THAT(held_out[2].median, Catch::Matchers::WithinAbs(0.5, 1e-9));  // half of what was measured
  CHECK_THAT(held_out[2].worst, Catch::Matchers::WithinAbs(0.5, 1e-9));
}

TEST_CASE("runs that cannot tell the costs apart are refused") {
  CHECK(message_of([] { fit_cost_model(runs(1, 4, 0)); }) ==
        "cost: 4 coefficients take 5 runs or more, there are 4; add scenes or samplers");
  // One view: L and P are the same in every run, whatever the rate.
  CHECK(message_of([] { fit_cost_model(runs(1, 8, 0)); }) ==
        "cost: these runs cannot tell the costs apart; add views, or samplers of other rates");
  CHECK(message_of([] { fit_cost_model({}); }) ==
        "cost: 0 coefficients take 1 runs or more, there are 0; add scenes or samplers");
}

}  // namespace
}  // namespace moire::test
