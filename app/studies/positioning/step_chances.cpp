#include "app/studies/positioning/step_chances.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "app/studies/positioning/base_standing.hpp"

namespace tubeplan::app {

namespace {

using Eigen::Index;

std::vector<double> mixed(const std::vector<calibration::TipErrorCase>& cases, const planner::Centring& predicted,
                          const tubesheets::SteppedTool& tool) {
  std::vector<double> chances(tool.steps.size() + 1, cases.empty() ? std::numeric_limits<double>::quiet_NaN() : 0);
  for (const auto& tip : cases) {
    const auto of_case = tubesheets::probabilityBySteps(tool, predicted.offset, tip.covariance, predicted.lean);
    for (std::size_t k = 0; k < chances.size(); ++k) chances[k] += tip.weight * of_case[k];
  }
  return chances;
}

/// Returns the joint uncertainty of base and arm that an identification stored in the cell's `uncertainty`, with the
/// base first. std::nullopt if it was stored without the base.
std::optional<calibration::JointUncertainty> determinedWithBase(const CellModel& cell, const deflection::Arm& arm) {
  const auto& determined = cell.uncertainty.determined;
  std::vector<Index> order;
  for (const auto& name : calibration::baseStepNames()) {
    const auto found = std::find(determined.begin(), determined.end(), name);
    if (found == determined.end()) return std::nullopt;
    order.push_back(found - determined.begin());
  }
  calibration::FreeChoice choice{{}, false, {}};
  for (std::size_t k = 0; k < determined.size(); ++k)
    if (deflection::findParameter(arm, determined[k])) {
      choice.names.push_back(determined[k]);
      order.push_back(static_cast<Index>(k));
    }
  calibration::PlacedArm placed{arm, {}};
  calibration::JointUncertainty joint{chooseUnknowns(placed, choice).list, cell.uncertainty.covariance(order, order)};
  for (std::size_t k = 0; k < joint.numbers.size(); ++k) {
    const double to_variable = 1 / slopeAt(joint.numbers[k], 0);
    joint.covariance.row(6 + static_cast<Index>(k)) *= to_variable;
    joint.covariance.col(6 + static_cast<Index>(k)) *= to_variable;
  }
  return joint;
}

/// Returns the joint uncertainty that the cell states of its base and arm.
calibration::JointUncertainty statedUncertainty(const CellModel& cell, const planner::Workcell& model) {
  if (cell.placed_by) {
    const double model_error = cell.model_error ? cell.model_error->sigma : 0;
    const auto numbers = calibration::uncertainNumbers(model.arm, cell.uncertainty);
    if (auto joint =
            calibration::uncertaintyByTouches(model.arm, model.X_WB, numbers, cell.placed_by->touches, model_error))
      return *std::move(joint);
  }
  if (cell.base_covariance)
    if (auto joint = determinedWithBase(cell, model.arm)) return *std::move(joint);
  return {{}, model.base_covariance};
}

}  // namespace

StepChances stepChances(const StepQuestion& question) {
  const CellModel& cell = question.cell;
  StepChances chances;
  if (!isPlaced(standingOf(cell, question.placed_by))) {
    chances.reason = "the base has not been calibrated: touch holes and calibrate (--touches)";
    return chances;
  }
  chances.model_error = question.placed_by ? modelErrorFor(cell, *question.placed_by) : cell.model_error;
  std::optional<calibration::StatedModelError> model_error;
  if (chances.model_error) model_error = {chances.model_error->sigma, chances.model_error->degrees_of_freedom};
  const calibration::TipErrorQuestion tip_error_question{
      question.model.arm,  question.model.X_WB,
      question.model.load, jointUncertaintyOf(cell, question.model, question.placed_by),
      model_error,         question.postures};
  chances.numbers_are_exact = tip_error_question.uncertainty.numbers.empty();
  chances.base_is_exact = tip_error_question.uncertainty.covariance.isZero(0);
  const auto errors = calibration::findTipError(tip_error_question);
  chances.by_posture.resize(question.postures.size());
  oneapi::tbb::parallel_for(std::size_t{0}, chances.by_posture.size(), [&](std::size_t k) {
    chances.by_posture[k] = mixed(errors[k], question.predicted[k], question.model.tool);
  });
  return chances;
}

calibration::JointUncertainty jointUncertaintyOf(const CellModel& cell, const planner::Workcell& model,
                                                 const calibration::BaseCalibration* placed_by) {
  return placed_by ? placed_by->uncertainty : statedUncertainty(cell, model);
}

int likeliestSteps(const std::vector<double>& chances) {
  return static_cast<int>(std::max_element(chances.begin(), chances.end()) - chances.begin());
}

std::vector<double> expectedCounts(const StepChances& chances) {
  std::vector<double> counts;
  for (const auto& of_hole : chances.by_posture) {
    counts.resize(of_hole.size(), 0);
    for (std::size_t k = 0; k < of_hole.size(); ++k)
      if (std::isfinite(of_hole[k])) counts[k] += of_hole[k];
  }
  return counts;
}

std::optional<ModelError> modelErrorFor(const CellModel& cell, const calibration::BaseCalibration& base) {
  if (base.is_model_error_found) return ModelError{base.model_error, base.degrees_of_freedom, kByTouches};
  return cell.knownModelError();
}

}  // namespace tubeplan::app
