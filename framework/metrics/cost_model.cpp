#include "metrics/cost_model.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>
#include <boost/math/distributions/students_t.hpp>

#include <moire/error.h>

namespace moire {

double CostModel::predict(const std::array<double, 4>& counts) const {
  double time = 0;
  for (std::size_t k = 0; k < counts.size(); ++k) time += coefficients[k].value * counts[k];
  return time;
}

CostModel fit_cost_model(std::span<const CostSample> samples) {
  constexpr Eigen::Index unknowns = 4;
  const auto rows = static_cast<Eigen::Index>(samples.size());
  if (rows <= unknowns) throw Error("cost: four coefficients take five runs or more; add scenes or samplers");

  // Every equation is divided by its time, every unknown's column by its norm.
  Eigen::MatrixXd equations(rows, unknowns);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const CostSample& sample = samples[static_cast<std::size_t>(i)];
    for (Eigen::Index k = 0; k < unknowns; ++k)
      equations(i, k) = sample.counts[static_cast<std::size_t>(k)] / sample.time;
  }
  const Eigen::RowVectorXd scale = equations.colwise().norm();
  if (!(scale.minCoeff() > 0)) throw Error("cost: an operation never happens in these runs; its cost cannot be told");
  for (Eigen::Index k = 0; k < unknowns; ++k) equations.col(k) /= scale(k);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(rows);

  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(equations);
  qr.setThreshold(1e-9);
  if (qr.rank() < unknowns)
    throw Error("cost: these runs cannot tell the four costs apart; add views, or samplers of other rates");
  const Eigen::VectorXd solution = qr.solve(ones);
  const double variance = (ones - equations * solution).squaredNorm() / static_cast<double>(rows - unknowns);
  const Eigen::MatrixXd covariance = variance * (equations.transpose() * equations).inverse();
  const double t = boost::math::quantile(boost::math::students_t(static_cast<double>(rows - unknowns)), 0.975);

  CostModel model;
  for (Eigen::Index k = 0; k < unknowns; ++k) {
    const double value = solution(k) / scale(k), half = t * std::sqrt(covariance(k, k)) / scale(k);
    model.coefficients[static_cast<std::size_t>(k)] = {value, value - half, value + half};
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
