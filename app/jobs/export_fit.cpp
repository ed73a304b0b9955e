#include "app/jobs/export_fit.hpp"

#include <algorithm>
#include <utility>

#include "app/documents/measurement_checks_json.hpp"
#include "app/jobs/identification.hpp"
#include "app/storage/input_error.hpp"
#include "app/studies/model/model_comparison.hpp"
#include "calibration/independent_geometry.hpp"
#include "deflection/effects/constant_effects.hpp"

namespace tubeplan::app {

namespace {

using calibration::IdentificationStatus;

/// Returns the part of an arm with constant effects as numbers that the file states.
deflection::Arm statedArm(deflection::Arm by_numbers, ArmFileContent content) {
  by_numbers.effects.clear();
  return content == ArmFileContent::kRigid ? deflection::rigidCopy(by_numbers) : by_numbers;
}

std::vector<std::string> leftOut(const deflection::Arm& by_numbers, ArmFileContent content) {
  std::vector<std::string> parts;
  for (const auto& effect : by_numbers.effects) parts.push_back("the effect " + deflection::textOf(by_numbers, effect));
  if (content == ArmFileContent::kRigid && std::ranges::any_of(by_numbers.rows, deflection::isCompliant))
    parts.emplace_back("stiffnesses and beams");
  return parts;
}

/// Returns the names of the cell's `identify` that are geometry or, for kCompliant, that the stated arm has; the tip
/// and the geometry if there are none.
std::vector<std::string> freedWithoutEffects(const Cell& cell, const deflection::Arm& stated, ArmFileContent content) {
  const auto known = calibration::freeableNames(stated);
  std::vector<std::string> names;
  for (const auto& name : cell.identify) {
    if (std::ranges::find(known, name) == known.end()) continue;
    const bool is_geometry = std::ranges::all_of(calibration::namesBehind(stated, name), calibration::isGeometry);
    if (is_geometry || content == ArmFileContent::kCompliant) names.push_back(name);
  }
  return names.empty() ? std::vector<std::string>{"tool.tip", "geometry"} : names;
}

[[noreturn]] void refuse(const CellMeasurements& input, const std::string& reason) {
  throw InputError::problem(input.file, "the arm cannot be fitted again: " + reason,
                            "see `tubeplan identify` for these measurements, or export without --measurements");
}

/// Returns the error of the cell's whole model, and removes its outliers from `input.measurements`.
calibration::ErrorSize errorOfModel(CellMeasurements& input, const WorkHooks& hooks) {
  if (input.cell.identify.empty() && input.cell.base_known)
    return comparisonRowOf("", input.cell, input.measurements, 1, hooks).fitted;
  IdentificationOutcome outcome = identifyModel(input, {}, hooks);
  if (outcome.fit.status != IdentificationStatus::kDone) refuse(input, outcome.fit.reason);
  input.measurements = std::move(outcome.measurements);
  return outcome.fit.after;
}

}  // namespace

bool statesAll(const deflection::Arm& arm, ArmFileContent content) {
  return leftOut(deflection::writeConstantEffects(arm).arm, content).empty();
}

ExportFit fitForExport(const CellMeasurements& given, ArmFileContent content, const WorkHooks& hooks) {
  if (const auto mistake = mistakeText(given.checks, given.cell.units); !mistake.empty())
    throw InputError::problem(given.file, mistake, "correct the measurements, or name the correction with --assume");
  CellMeasurements input = given;
  if (input.cell.base_covariance) input.cell.base_known = false;  // the base was found, and is found again with the arm
  ExportFit result;
  deflection::Arm by_numbers = deflection::writeConstantEffects(input.cell.arm).arm;
  result.left_out = leftOut(by_numbers, content);
  beginStep(hooks, "fit of the cell's model");
  result.of_model = errorOfModel(input, hooks);
  beginStep(hooks, "fit of what the file states");
  input.cell.arm = statedArm(std::move(by_numbers), content);
  input.cell.identify = freedWithoutEffects(given.cell, input.cell.arm, content);
  const auto fit = fitForLadder(input.cell, input.measurements, 1, hooks);
  if (fit.status != IdentificationStatus::kDone) refuse(input, fit.reason);
  result.arm = fit.fitted.arm;
  result.measurements = static_cast<int>(fit.used.size());
  result.as_fitted = fit.after_base;
  result.refitted = fit.after;
  result.heldout = fit.heldout;
  return result;
}

}  // namespace tubeplan::app
