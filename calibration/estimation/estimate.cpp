#include "calibration/estimation/estimate.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "calibration/estimation/fit.hpp"
#include "calibration/estimation/identification.hpp"
#include "calibration/measurements/reading_placement.hpp"
#include "calibration/measurements/reading_prediction.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

void takeFit(const Identification& fit, Estimate& estimate) {
  estimate.start = fit.start;
  estimate.unknowns.clear();
  estimate.x.resize(static_cast<Index>(fit.numbers.size()));
  for (const auto& number : fit.numbers) {
    estimate.x[static_cast<Index>(estimate.unknowns.size())] = variableAt(number.unknown, number.value);
    estimate.unknowns.push_back(number.unknown);
  }
  estimate.model_error = fit.model_error;
}

/// J^T J of the readings, by variables over their typical sizes; nothing where the model cannot be evaluated.
MatrixXd informationOf(const Estimate& estimate, const std::vector<Measurement>& readings) {
  const auto n = static_cast<Index>(estimate.unknowns.size());
  const auto weights = weighReadings(placedAsEstimated(estimate), readings, {}, estimate.model_error);
  if (!weights) return MatrixXd::Zero(n, n);
  auto residual = whitenedResidual(estimate.start, estimate.unknowns, readings, *weights, estimate.x, true);
  if (!residual.ok) return MatrixXd::Zero(n, n);
  for (Index k = 0; k < n; ++k) residual.jacobian.col(k) *= estimate.unknowns[static_cast<std::size_t>(k)].typical;
  return residual.jacobian.transpose() * residual.jacobian;
}

/// Each variable is known to its typical size, or better by a prior of its own.
VectorXd informationBeforehand(const std::vector<Unknown>& unknowns) {
  VectorXd information(static_cast<Index>(unknowns.size()));
  for (Index k = 0; k < information.size(); ++k) {
    const Unknown& unknown = unknowns[static_cast<std::size_t>(k)];
    information[k] = std::max(1., std::pow(unknown.typical / unknown.prior_sigma, 2));
  }
  return information;
}

}  // namespace

Estimate estimateFrom(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, bool base_known,
                      const std::vector<Measurement>& readings, const FreeChoice& free) {
  std::vector<Measurement> used;
  std::copy_if(readings.begin(), readings.end(), std::back_inserter(used),
               [](const Measurement& reading) { return !reading.is_held_out; });
  Estimate estimate;
  estimate.start = placeForReadings(arm, X_WB, base_known, used);
  auto unknowns = chooseUnknowns(estimate.start, free);
  estimate.problems = unknowns.problems;
  estimate.unknowns = std::move(unknowns.list);
  if (!estimate.problems.empty()) return estimate;
  estimate.x = VectorXd::Zero(static_cast<Index>(estimate.unknowns.size()));
  estimate.information = informationBeforehand(estimate.unknowns).asDiagonal();
  if (used.empty() || estimate.unknowns.empty()) return estimate;
  IdentificationOptions options;
  options.free = free;
  options.folds = 0;
  options.intervals_by_profile = false;
  const Identification fit = identify(arm, X_WB, base_known, used, options);
  if (fit.status == IdentificationStatus::kDone) {
    takeFit(fit, estimate);
  } else {
    estimate.note = fit.reason;
    alignBases(estimate.start, used);
  }
  estimate.information += informationOf(estimate, used);
  return estimate;
}

PlacedArm placedAsEstimated(const Estimate& estimate) { return applied(estimate.start, estimate.unknowns, estimate.x); }

std::vector<MatrixXd> tipSensitivities(const Estimate& estimate, const std::vector<VectorXd>& postures, double load) {
  std::vector<Measurement> tips;
  ReadingWeights weights;  // none: every coordinate as it is
  for (const auto& q : postures) {
    Measurement tip;
    tip.q = q;
    tip.load = load;
    tip.setup = estimate.start.base_poses.back().setup;
    tip.p_W = Eigen::Vector3d::Zero();
    tips.push_back(tip);
    weights.first_row.push_back(weights.rows);
    weights.whitener.push_back(MatrixXd::Identity(3, 3));
    weights.rows += 3;
  }
  const auto residual = whitenedResidual(estimate.start, estimate.unknowns, tips, weights, estimate.x, true);
  assert(residual.ok);
  std::vector<MatrixXd> sensitivities;
  for (std::size_t k = 0; k < postures.size(); ++k) {
    MatrixXd by_variables = residual.jacobian.middleRows(3 * static_cast<Index>(k), 3);
    for (Index j = 0; j < by_variables.cols(); ++j)
      by_variables.col(j) *= estimate.unknowns[static_cast<std::size_t>(j)].typical;
    sensitivities.push_back(by_variables);
  }
  return sensitivities;
}

}  // namespace tubeplan::calibration
