// What a frame costs as a sum over its operations: Cohen-Or 1997, section 6.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

namespace moire {

// Operations counted in one run, per image column.
struct CostSample {
  std::string scene, sampler;
  std::array<double, 4> counts;  // L steps, P pixels, M sampled elements, hits
  double time;                   // ns per column; above 0
};

struct Coefficient {
  double value = 0;          // ns per operation
  double low = 0, high = 0;  // 95 % confidence, Student's t
};

// time = a L + b P + c M + d hits.
struct CostModel {
  std::array<Coefficient, 4> coefficients;

  double predict(const std::array<double, 4>& counts) const;
};

// Least squares of relative errors: every run counts alike, however long it took.
// Error: fewer than five samples, or samples that cannot tell the four apart.
CostModel fit_cost_model(std::span<const CostSample> samples);

// How wrong the model is about a scene that it was not fitted to: |predicted - measured| / measured.
struct HeldOut {
  std::string scene;
  double median = 0, worst = 0;
};

// Each scene in turn, by a fit to all others. Error: as fit_cost_model.
std::vector<HeldOut> predict_held_out(std::span<const CostSample> samples);

}  // namespace moire
