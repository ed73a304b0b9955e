#include "app/jobs/cell_estimate.hpp"

#include "app/formats/measurements/measurement_input.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"

namespace tubeplan::app {

MeasurementsWithChecks measurementsMade(const std::string& file, Cell& cell, double sigma,
                                        const std::vector<std::string>& assume) {
  if (file.empty()) return {};
  return readAndCheck({file}, cell, {sigma / cell.units.factor(dimension::kLength), {}, assume});
}

calibration::Estimate estimateOf(const Cell& cell, const std::vector<calibration::Measurement>& measurements,
                                 const calibration::FreeChoice& free, const std::string& where,
                                 const calibration::AdditionalUncertainty& additional) {
  auto estimate = calibration::estimateFrom(cell.arm, cell.X_WB, cell.base_known, measurements, free, additional);
  if (estimate.problems.empty()) return estimate;
  refuseName(where, estimate.problems.front(), cell.arm);
}

void refuseName(const std::string& where, const calibration::FreeProblem& problem, const deflection::Arm& arm) {
  std::string advice = problem.advice;
  if (problem.is_unknown)
    if (auto near = suggestion(problem.name, calibration::freeableNames(arm)); !near.empty()) advice = std::move(near);
  throw InputError::problem(where, problem.what, advice);
}

Cell cellAsEstimated(Cell cell, const calibration::Estimate& estimate) {
  const auto placed = calibration::placedAsEstimated(estimate);
  cell.arm = placed.arm;
  cell.X_WB = placed.base_poses.back().X_WB;
  return cell;
}

}  // namespace tubeplan::app
