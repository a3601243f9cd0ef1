// What a frame costs as a sum over its operations: Cohen-Or 1997, section 6.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace moire {

// The operations of one run, per image column: L steps, P pixels, M sampled elements, hits of points, and runs that
// lines find (the paper's hits of area sampling, which cost d' each).
constexpr std::size_t cost_operations = 5;
using OperationCounts = std::array<double, cost_operations>;

struct CostSample {
  std::string scene, sampler;
  OperationCounts counts;
  double time;  // ns per column; above 0
};

struct Coefficient {
  double value = 0;          // ns per operation
  double low = 0, high = 0;  // 95 % confidence, Student's t
};

// time = a L + b P + c M + d hits + d' runs.
struct CostModel {
  std::array<std::optional<Coefficient>, cost_operations> coefficients;  // none: the operation never happened

  double predict(const OperationCounts& counts) const;
};

// Least squares of relative errors: every run counts alike, however long it took.
// Error: no more samples than operations, or samples that cannot tell these apart.
CostModel fit_cost_model(std::span<const CostSample> samples);

// How wrong the model is about a scene that it was not fitted to: |predicted - measured| / measured.
struct HeldOut {
  std::string scene;
  double median = 0, worst = 0;
};

// Each scene in turn, by a fit to all others. Error: as fit_cost_model.
std::vector<HeldOut> predict_held_out(std::span<const CostSample> samples);

}  // namespace moire
