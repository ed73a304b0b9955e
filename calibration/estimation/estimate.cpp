#include "calibration/estimation/estimate.hpp"

#include <algorithm>
#include <cassert>

#include "calibration/estimation/base_calibration.hpp"
#include "calibration/estimation/fit.hpp"
#include "calibration/estimation/identification.hpp"
#include "calibration/estimation/prior.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/measurement_placement.hpp"

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
  estimate.model_error = std::max(fit.model_error, estimate.model_error);
}

/// Returns the information matrix of the measurements, J^T J; zero if the model cannot be evaluated.
MatrixXd informationOf(const Estimate& estimate, const std::vector<Measurement>& measurements) {
  const auto weights = weighMeasurements(placedAsEstimated(estimate), measurements, {}, estimate.model_error);
  const auto by_variables = weights ? sensitivityOf(estimate, measurements, *weights) : std::nullopt;
  if (!by_variables) return MatrixXd::Zero(estimate.information.rows(), estimate.information.cols());
  return by_variables->transpose() * *by_variables;
}

/// Returns the diagonal of the prior information matrix. The prior sigma of a free variable is its typical size, or the
/// sigma of its own prior if smaller; each standard normal variable of `nuisance_parameters` has variance 1.
VectorXd informationBeforehand(const Estimate& estimate) {
  const VectorXd of_free = priorInformation(estimate.unknowns);
  VectorXd information = VectorXd::Ones(of_free.size() + estimate.nuisance_parameters.root.cols());
  information.head(of_free.size()) = of_free.cwiseMax(1);
  return information;
}

/// Returns true if the only unknown is one base pose, and if all measurements are touches that calibrateBase() accepts.
bool placesByTouches(const Estimate& estimate, const std::vector<Measurement>& measurements) {
  const bool is_base_alone = std::ranges::all_of(
      estimate.unknowns, [](const Unknown& unknown) { return unknown.owner == Unknown::Owner::kBase; });
  return is_base_alone && estimate.start.base_poses.size() == 1 &&
         std::ranges::all_of(measurements,
                             [](const Measurement& measurement) { return touchesKnownPoint(measurement); }) &&
         findTouchProblem(measurements).empty();
}

/// Fits the base together with the arm's uncertain parameters; returns false if the fit does not converge.
bool fitBaseByTouches(const std::vector<Measurement>& touches, Estimate& estimate) {
  BasePose& base = estimate.start.base_poses.front();
  const TouchFit fit = fitTouches(estimate.start.arm, estimate.nuisance_parameters, touches, base.X_WB,
                                  {.model_error = estimate.model_error});
  estimate.note = fit.reason;
  if (fit.status != LeastSquaresStatus::kConverged) return false;
  estimate.note.clear();
  base.X_WB = fit.X_WB;
  estimate.start.arm = fit.arm;
  estimate.nuisance_parameters.unknowns = fit.uncertainty.numbers;
  estimate.model_error = fit.model_error;
  return true;
}

/// Fits the free parameters, treating all others as exact. Returns false if the fit fails.
bool fitFreeNumbers(const PlacedArm& placed, const std::vector<Measurement>& measurements, const FreeChoice& free,
                    Estimate& estimate) {
  IdentificationOptions options;
  options.free = free;
  options.folds = 0;
  options.intervals_by_profile = false;
  const Identification fit = identify(placed, measurements, options);
  estimate.note = fit.reason;
  if (fit.status != IdentificationStatus::kDone) return false;
  estimate.note.clear();
  takeFit(fit, estimate);
  return true;
}

}  // namespace

Estimate estimateFrom(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, bool base_known,
                      const std::vector<Measurement>& measurements, const FreeChoice& free,
                      const AdditionalUncertainty& additional) {
  std::vector<Measurement> used = measurements;
  std::erase_if(used, [](const Measurement& measurement) { return measurement.is_held_out; });
  Estimate estimate;
  const PlacedArm placed = placeForMeasurements(arm, X_WB, base_known, used);
  estimate.start = placed;
  auto unknowns = chooseUnknowns(estimate.start, free);
  estimate.problems = unknowns.problems;
  estimate.unknowns = std::move(unknowns.list);
  if (!estimate.problems.empty()) return estimate;
  estimate.x = zerosOf(estimate.unknowns);
  estimate.nuisance_parameters = uncertainNumbers(arm, additional.arm);
  estimate.model_error = additional.model_error;
  estimate.information = informationBeforehand(estimate).asDiagonal();
  if (used.empty() || estimate.unknowns.empty()) return estimate;
  const bool is_fitted = !estimate.nuisance_parameters.unknowns.empty() && placesByTouches(estimate, used)
                             ? fitBaseByTouches(used, estimate)
                             : fitFreeNumbers(placed, used, free, estimate);
  if (!is_fitted) alignBases(estimate.start, used);
  estimate.information += informationOf(estimate, used);
  return estimate;
}

PlacedArm placedAsEstimated(const Estimate& estimate) { return applied(estimate.start, estimate.unknowns, estimate.x); }

std::optional<MatrixXd> sensitivityOf(const Estimate& estimate, const std::vector<Measurement>& measurements,
                                      const MeasurementWeights& weights) {
  const auto& [numbers, root] = estimate.nuisance_parameters;
  const auto free = static_cast<Index>(estimate.unknowns.size()), nuisance_count = static_cast<Index>(numbers.size());
  std::vector<Unknown> all = estimate.unknowns;
  all.insert(all.end(), numbers.begin(), numbers.end());
  VectorXd x = VectorXd::Zero(free + nuisance_count);
  x.head(free) = estimate.x;
  const auto residual = whitenedResidual(estimate.start, all, measurements, weights, x, true);
  if (!residual.ok) return std::nullopt;
  MatrixXd by_variables(residual.jacobian.rows(), free + root.cols());
  by_variables.leftCols(free) = residual.jacobian.leftCols(free) * typicalsOf(estimate.unknowns).asDiagonal();
  by_variables.rightCols(root.cols()) = residual.jacobian.rightCols(nuisance_count) * root;
  return by_variables;
}

std::vector<MatrixXd> tipSensitivities(const Estimate& estimate, const std::vector<VectorXd>& postures, double load) {
  std::vector<Measurement> tips;
  MeasurementWeights weights;  // identity whiteners keep the Jacobian in metres
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
  const auto by_variables = sensitivityOf(estimate, tips, weights);
  assert(by_variables);
  std::vector<MatrixXd> sensitivities;
  for (std::size_t k = 0; k < postures.size(); ++k)
    sensitivities.emplace_back(by_variables->middleRows(3 * static_cast<Index>(k), 3));
  return sensitivities;
}

}  // namespace tubeplan::calibration
