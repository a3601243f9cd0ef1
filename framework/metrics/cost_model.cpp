#include "metrics/cost_model.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Dense>
#include <boost/math/distributions/students_t.hpp>

#include <moire/error.h>

namespace moire {

double CostModel::predict(const OperationCounts& counts) const {
  double time = 0;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (coefficients[k]) time += coefficients[k]->value * counts[k];
  }
  return time;
}

CostModel fit_cost_model(std::span<const CostSample> samples) {
  std::vector<std::size_t> operations;  // those that happen
  for (std::size_t k = 0; k < cost_operations; ++k) {
    if (std::any_of(samples.begin(), samples.end(), [&](const CostSample& sample) { return sample.counts[k] != 0; }))
      operations.push_back(k);
  }
  const auto rows = static_cast<Eigen::Index>(samples.size()), unknowns = static_cast<Eigen::Index>(operations.size());
  if (rows <= unknowns) {
    throw Error(fmt::format("cost: {} coefficients take {} runs or more, there are {}; add scenes or samplers",
                            unknowns, unknowns + 1, rows));
  }

  // Every equation is divided by its time, every unknown's column by its norm.
  Eigen::MatrixXd equations(rows, unknowns);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const CostSample& sample = samples[static_cast<std::size_t>(i)];
    for (Eigen::Index k = 0; k < unknowns; ++k)
      equations(i, k) = sample.counts[operations[static_cast<std::size_t>(k)]] / sample.time;
  }
  const Eigen::RowVectorXd scale = equations.colwise().norm();
  for (Eigen::Index k = 0; k < unknowns; ++k) equations.col(k) /= scale(k);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(rows);

  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(equations);
  qr.setThreshold(1e-9);
  if (qr.rank() < unknowns)
    throw Error("cost: these runs cannot tell the costs apart; add views, or samplers of other rates");
  const Eigen::VectorXd solution = qr.solve(ones);
  const auto freedom = static_cast<double>(rows - unknowns);
  const double variance = (ones - equations * solution).squaredNorm() / freedom;
  const Eigen::MatrixXd covariance = variance * (equations.transpose() * equations).inverse();
  const double t = boost::math::quantile(boost::math::students_t(freedom), 0.975);

  CostModel model;
  for (Eigen::Index k = 0; k < unknowns; ++k) {
    const double value = solution(k) / scale(k), half = t * std::sqrt(covariance(k, k)) / scale(k);
    model.coefficients[operations[static_cast<std::size_t>(k)]] = {value, value - half, value + half};
  }
  return model;
}

std::vector<HeldOut> predict_held_out(std::span<const CostSample> samples) {
  std::vector<HeldOut> result;
  for (const CostSample& sample : samples) {
    const auto is_same = [&](const HeldOut& h) { return h.scene == sample.scene; };
    if (std::none_of(result.begin(), result.end(), is_same)) result.push_back({sample.scene});
  }
  for (HeldOut& held_out : result) {
    std::vector<CostSample> others;
    std::copy_if(samples.begin(), samples.end(), std::back_inserter(others),
                 [&](const CostSample& sample) { return sample.scene != held_out.scene; });
    const CostModel model = fit_cost_model(others);
    std::vector<double> errors;
    for (const CostSample& sample : samples) {
      if (sample.scene == held_out.scene) errors.push_back(std::abs(model.predict(sample.counts) / sample.time - 1));
    }
    std::sort(errors.begin(), errors.end());
    held_out.median = (errors[(errors.size() - 1) / 2] + errors[errors.size() / 2]) / 2;
    held_out.worst = errors.back();
  }
  return result;
}

}  // namespace moire
