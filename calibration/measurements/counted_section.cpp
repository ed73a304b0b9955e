#include "calibration/measurements/counted_section.hpp"

#include <algorithm>

#include "calibration/measurements/measurement_posture.hpp"
#include "calibration/measurements/steps.hpp"

namespace tubeplan::calibration {

namespace {

constexpr double kNoBound = 1;  // largest offset at a visit without any step [m]

}  // namespace

std::optional<ToolAxis> toolAxisAt(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                   const Measurement& measurement) {
  const auto shape = deflection::solveFlexibleKinematics(arm, postureOf(measurement, arm, X_WB));
  if (shape.status != deflection::KinematicsStatus::kConverged) return std::nullopt;
  return ToolAxis{X_WB.linear() * shape.X_BD.R * arm.tool_axis_L, shape.R_LT.transpose() * arm.tool_axis_L};
}

void settleCount(Measurement& measurement, const tubesheets::SteppedTool& tool, const deflection::Arm& arm,
                 const Eigen::Isometry3d& X_WB) {
  const auto entered = static_cast<std::size_t>(measurement.kind_values[0]);
  const bool all_entered = entered == tool.steps.size();
  const std::size_t step = std::min(entered, tool.steps.size() - 1);
  double play = 0;
  const bool has_section = !tool.lengths.empty() && !measurement.p_TQ;
  if (const auto axis = has_section ? toolAxisAt(arm, X_WB, measurement) : std::nullopt) {
    measurement.p_QS = -tubesheets::middleOf(tool, step) * axis->axis_T;
    if (!all_entered && axis->isUpward()) play = std::min(axis->lean().norm(), 1.) * tool.lengths[step] / 2;
  }
  measurement.kind_values[1] = all_entered ? 0 : std::max(tool.steps[step].tolerance - play, 0.);
  measurement.kind_values[2] = entered > 0 ? tool.steps[entered - 1].tolerance + play : kNoBound;
  measurement.sigma = steps::sigmaBetween(measurement.kind_values[1], measurement.kind_values[2]);
}

}  // namespace tubeplan::calibration
