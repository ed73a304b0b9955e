#include "calibration/estimation/knowledge.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "calibration/estimation/fit.hpp"
#include "calibration/estimation/identification.hpp"
#include "calibration/measurements/reading_prediction.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

void takeFit(const Identification& fit, Knowledge& knowledge) {
  knowledge.start = fit.start;
  knowledge.unknowns.clear();
  knowledge.x.resize(static_cast<Index>(fit.numbers.size()));
  for (const auto& number : fit.numbers) {
    knowledge.x[static_cast<Index>(knowledge.unknowns.size())] = variableAt(number.unknown, number.value);
    knowledge.unknowns.push_back(number.unknown);
  }
  knowledge.model_error = fit.model_error;
}

/// J^T J of the readings, by variables over their typical sizes; nothing where the model cannot be evaluated.
MatrixXd informationOf(const Knowledge& knowledge, const std::vector<Measurement>& readings) {
  const auto n = static_cast<Index>(knowledge.unknowns.size());
  const auto weights = weighReadings(placedAsKnown(knowledge), readings, {}, knowledge.model_error);
  if (!weights) return MatrixXd::Zero(n, n);
  auto residual = whitenedResidual(knowledge.start, knowledge.unknowns, readings, *weights, knowledge.x, true);
  if (!residual.ok) return MatrixXd::Zero(n, n);
  for (Index k = 0; k < n; ++k) residual.jacobian.col(k) *= knowledge.unknowns[static_cast<std::size_t>(k)].typical;
  return residual.jacobian.transpose() * residual.jacobian;
}

}  // namespace

Knowledge learnFrom(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, bool base_known,
                    const std::vector<Measurement>& readings, const FreeChoice& free) {
  std::vector<Measurement> used;
  std::copy_if(readings.begin(), readings.end(), std::back_inserter(used),
               [](const Measurement& reading) { return !reading.is_held_out; });
  Knowledge knowledge;
  knowledge.start = placeForReadings(arm, X_WB, base_known, used);
  auto unknowns = chooseUnknowns(knowledge.start, free);
  knowledge.problems = unknowns.problems;
  knowledge.unknowns = std::move(unknowns.list);
  if (!knowledge.problems.empty()) return knowledge;
  knowledge.x = VectorXd::Zero(static_cast<Index>(knowledge.unknowns.size()));
  knowledge.information = weakInformation(knowledge.unknowns);
  if (used.empty() || knowledge.unknowns.empty()) return knowledge;
  IdentificationOptions options;
  options.free = free;
  options.folds = 0;
  options.intervals_by_profile = false;
  const Identification fit = identify(arm, X_WB, base_known, used, options);
  if (fit.status == IdentificationStatus::kDone) {
    takeFit(fit, knowledge);
  } else {
    knowledge.note = fit.reason;
    alignPlacings(knowledge.start, used);
  }
  knowledge.information += informationOf(knowledge, used);
  return knowledge;
}

MatrixXd weakInformation(const std::vector<Unknown>& unknowns) {
  const auto n = static_cast<Index>(unknowns.size());
  return MatrixXd::Identity(n, n);
}

PlacedArm placedAsKnown(const Knowledge& knowledge) {
  return applied(knowledge.start, knowledge.unknowns, knowledge.x);
}

std::vector<MatrixXd> tipSensitivities(const Knowledge& knowledge, const std::vector<VectorXd>& postures, double load) {
  std::vector<Measurement> tips;
  ReadingWeights weights;  // none: every coordinate as it is
  for (const auto& q : postures) {
    Measurement tip;
    tip.q = q;
    tip.load = load;
    tip.setup = knowledge.start.placings.back().setup;
    tip.p_W = Eigen::Vector3d::Zero();
    tips.push_back(tip);
    weights.first_row.push_back(weights.rows);
    weights.whitener.push_back(MatrixXd::Identity(3, 3));
    weights.rows += 3;
  }
  const auto residual = whitenedResidual(knowledge.start, knowledge.unknowns, tips, weights, knowledge.x, true);
  assert(residual.ok);
  std::vector<MatrixXd> sensitivities;
  for (std::size_t k = 0; k < postures.size(); ++k) {
    MatrixXd by_variables = residual.jacobian.middleRows(3 * static_cast<Index>(k), 3);
    for (Index j = 0; j < by_variables.cols(); ++j)
      by_variables.col(j) *= knowledge.unknowns[static_cast<std::size_t>(j)].typical;
    sensitivities.push_back(by_variables);
  }
  return sensitivities;
}

}  // namespace tubeplan::calibration
