#include "calibration/diagnosis/judgement/diagnosis_views.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "calibration/diagnosis/explanations/explanation_model.hpp"
#include "calibration/diagnosis/judgement/diagnosis_result.hpp"
#include "calibration/estimation/set_aside.hpp"
#include "calibration/estimation/span.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/measurement_prediction.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

namespace {

constexpr std::size_t kMostShown = 4;

WhitenedResidual residualOf(const FittedBasis& basis, const PlacedArm& placed) {
  return whitenedResidual(placed, {}, basis.measurements, basis.weights, VectorXd(0), false);
}

/// Returns the error of a measurement, measured minus predicted, as a vector [m].
Vector3d missAt(const FittedBasis& basis, std::size_t k, const std::optional<ToolPose>& tool,
                const WhitenedResidual& residual) {
  if (!residual.ok || !tool) return Vector3d::Constant(kNotKnown);
  const Measurement& measurement = basis.measurements[k];
  ToolPose seen = *tool;
  if (const Measurement* reference = referenceOf(measurement))
    if (const auto from = toolAt(basis.fitted, *reference)) seen.p_W -= from->p_W;
  const Index row = basis.weights.first_row[k];
  return -predictedSlope(measurement, seen).by_place.transpose() * residual.error.segment(row, rowsOf(measurement));
}

double turnAt(const FittedBasis& basis, std::size_t k, const WhitenedResidual& residual) {
  if (!residual.ok) return kNotKnown;
  const Measurement& measurement = basis.measurements[k];
  return turnError(measurement, residual.error.segment(basis.weights.first_row[k], rowsOf(measurement)));
}

std::vector<MeasurementView> measurementViews(const FittedBasis& basis, const std::vector<Explanation>& shown,
                                              const std::vector<int>& given) {
  std::vector<WhitenedResidual> after;
  for (const auto& explanation : shown) after.push_back(residualOf(basis, explanation.fitted));
  std::vector<MeasurementView> views;
  for (std::size_t k = 0; k < basis.measurements.size(); ++k) {
    MeasurementView view;
    view.measurement = given[k];
    const auto tool = toolAt(basis.fitted, basis.measurements[k]);
    view.p_WT = tool ? tool->p_W : Vector3d::Constant(kNotKnown);
    view.before = missAt(basis, k, tool, basis.residual);
    view.turn_before = turnAt(basis, k, basis.residual);
    for (const auto& residual : after) {
      view.after.push_back(missAt(basis, k, tool, residual));
      view.turn_after.push_back(turnAt(basis, k, residual));
    }
    views.push_back(std::move(view));
  }
  return views;
}

/// Returns the change of the whitened residuals due to an effect at its fitted size, added to the model without
/// effects.
VectorXd signatureOf(const FittedBasis& basis, const FoundEffect& found, const PlacedArm& fitted) {
  PlacedArm with = basis.fitted;
  if (found.frees.empty()) with.arm.effects.push_back(found.fitted);
  for (const auto& name : found.frees)
    if (const auto freed = deflection::findParameter(fitted.arm, name))
      deflection::locate(with.arm, freed->path) = freed->value;
  const WhitenedResidual residual = residualOf(basis, with);
  return residual.ok ? VectorXd(residual.r - basis.residual.r) : VectorXd();
}

/// Returns true if measurement `k` is in an evenly spread subset with the fraction `share` of all measurements. A
/// golden-ratio step avoids aliasing with periodic patterns in the measurements.
bool isKept(std::size_t k, double share) {
  constexpr double kGolden = 0.6180339887498949;
  const double turn = kGolden * static_cast<double>(k);
  return turn - std::floor(turn) < share;
}

std::vector<AddedVariablePoint> addedPointsOf(const FittedBasis& basis, const std::vector<int>& given,
                                              const VectorXd& signature, const VectorXd& residual, int most_points) {
  // The number of kept measurements is approximate, so aim one percent below the limit.
  const bool is_thinned = signature.size() > most_points;
  const double share = is_thinned ? 0.99 * most_points / static_cast<double>(signature.size()) : 1;
  std::vector<AddedVariablePoint> points;
  for (std::size_t k = 0; k < basis.measurements.size(); ++k) {
    if (!isKept(k, share)) continue;
    const Index first = basis.weights.first_row[k];
    for (Index row = first; row < first + rowsOf(basis.measurements[k]); ++row)
      points.push_back({given[k], signature[row], residual[row]});
  }
  return points;
}

void addVariables(const FittedBasis& basis, const Explanation& explanation, int index, const std::vector<int>& given,
                  int most_points, std::vector<AddedVariable>& added) {
  std::vector<VectorXd> signatures;
  for (const auto& effect : explanation.effects) signatures.push_back(signatureOf(basis, effect, explanation.fitted));
  for (std::size_t e = 0; e < signatures.size(); ++e) {
    if (signatures[e].size() == 0) continue;
    MatrixXd columns = basis.residual.jacobian;
    for (std::size_t other = 0; other < signatures.size(); ++other) {
      if (other == e || signatures[other].size() == 0) continue;
      columns.conservativeResize(columns.rows(), columns.cols() + 1);
      columns.rightCols<1>() = signatures[other];
    }
    const VectorXd signature = partOutsideSpan(columns, signatures[e]);
    const VectorXd residual = partOutsideSpan(columns, -basis.residual.r);
    AddedVariable variable;
    variable.explanation = index;
    variable.effect = static_cast<int>(e);
    variable.length = signature.norm();
    variable.kept_fraction = variable.length / std::max(1e-300, signatures[e].norm());
    if (variable.length > 0) variable.slope = signature.dot(residual) / signature.squaredNorm();
    variable.points = addedPointsOf(basis, given, signature, residual, most_points);
    added.push_back(std::move(variable));
  }
}

}  // namespace

std::vector<Explanation> explanationsShown(const Diagnosis& result) {
  if (result.verdict == Verdict::kAdequate) return {};
  const auto& all = result.alternatives.empty() ? result.closest : result.alternatives;
  return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), kMostShown))};
}

DiagnosisViews viewsOf(const FittedBasis& basis, const Diagnosis& result, const std::vector<Measurement>& measurements,
                       int most_points) {
  const auto given = placesFitted(measurements, result.set_aside);
  assert(given.size() == basis.measurements.size());
  const auto shown = explanationsShown(result);
  DiagnosisViews views{measurementViews(basis, shown, given), {}};
  for (std::size_t x = 0; x < shown.size(); ++x)
    addVariables(basis, shown[x], static_cast<int>(x), given, most_points, views.added);
  return views;
}

}  // namespace tubeplan::calibration
