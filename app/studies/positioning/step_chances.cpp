#include "app/studies/positioning/step_chances.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "calibration/statistics.hpp"

namespace tubeplan::app {

namespace {

using calibration::ModelErrorSource;

std::vector<double> mixed(const std::vector<calibration::TipErrorCase>& cases, const planner::Centring& predicted,
                          const tubesheets::SteppedTool& tool) {
  std::vector<double> chances(tool.steps.size() + 1, cases.empty() ? std::numeric_limits<double>::quiet_NaN() : 0);
  for (const auto& tip : cases) {
    const auto of_case =
        tubesheets::probabilityBySteps(tool, predicted.offset + tip.mean, tip.covariance, predicted.lean);
    for (std::size_t k = 0; k < chances.size(); ++k) chances[k] += tip.weight * of_case[k];
  }
  return chances;
}

std::optional<calibration::StatedModelError> statedBy(const CellModel& cell, bool has_touches) {
  // What earlier touches said of the model the new ones say again, perhaps being the same.
  if (!cell.model_error || (has_touches && !isFoundElsewhere(cell.model_error))) return std::nullopt;
  return calibration::StatedModelError{cell.model_error->sigma, cell.model_error->degrees_of_freedom};
}

}  // namespace

StepChances stepChances(const StepQuestion& question) {
  const CellModel& cell = question.cell;
  StepChances chances;
  chances.touches = static_cast<int>(question.touches.size());
  if (question.touches.empty() && !cell.base_known && !cell.base_covariance) {
    chances.reason = "the base has not been calibrated: touch holes and calibrate (--touches)";
    return chances;
  }
  chances.base_is_exact = question.touches.empty() && question.model.base_covariance.isZero(0);
  const calibration::TipErrorQuestion asked{question.model.arm,
                                            question.model.X_WB,
                                            question.model.load,
                                            question.touches,
                                            question.model.base_covariance,
                                            statedBy(cell, !question.touches.empty()),
                                            question.postures};
  chances.error = calibration::findTipError(asked);
  chances.by_posture.resize(question.postures.size());
  oneapi::tbb::parallel_for(std::size_t{0}, chances.by_posture.size(), [&](std::size_t k) {
    chances.by_posture[k] = mixed(chances.error.at[k], question.predicted[k], question.model.tool);
  });
  chances.error.at.clear();
  return chances;
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

bool isFoundElsewhere(const std::optional<ModelError>& error) { return error && error->from != kByTouches; }

std::optional<ModelError> modelErrorByTouches(const calibration::TipError& error, std::size_t touches) {
  if (error.source != ModelErrorSource::kTouches) return std::nullopt;
  const int freedom = 3 * static_cast<int>(touches) - 6;
  const double middle = calibration::chiSquareQuantile(0.5, freedom);
  return ModelError{error.model_error * std::sqrt(middle / freedom), freedom, kByTouches};
}

}  // namespace tubeplan::app
