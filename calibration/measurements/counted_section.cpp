#include "calibration/measurements/counted_section.hpp"

#include <algorithm>

#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/measurements/steps.hpp"

namespace tubeplan::calibration {

using Eigen::Vector2d, Eigen::Vector3d;

namespace {

constexpr double kNoBound = 1;  // largest offset at a visit without any step [m]

/// Returns the depth below the tip of the middle of a step [m].
double middleOf(const tubesheets::SteppedTool& tool, std::size_t step) {
  double below = 0;
  for (std::size_t k = 0; k < step; ++k) below += tool.lengths[k];
  return below + tool.lengths[step] / 2;
}

}  // namespace

Vector3d toolAxisInTool(const deflection::Arm& arm) { return deflection::toolFrame(arm).transpose() * arm.tool_axis_L; }

std::optional<Vector2d> toolLean(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                 const Measurement& measurement) {
  const auto tool = toolAt(arm, X_WB, measurement);
  if (!tool) return std::nullopt;
  const Vector3d axis_W = tool->R_WT * toolAxisInTool(arm);
  return axis_W.z() > 0 ? std::optional<Vector2d>(axis_W.head<2>() / axis_W.z()) : std::nullopt;
}

void settleCount(Measurement& measurement, const tubesheets::SteppedTool& tool, const deflection::Arm& arm,
                 const Eigen::Isometry3d& X_WB) {
  const auto entered = static_cast<std::size_t>(measurement.own[0]);
  const bool all_entered = entered == tool.steps.size();
  const std::size_t step = std::min(entered, tool.steps.size() - 1);
  double play = 0;
  if (!tool.lengths.empty() && !measurement.p_TQ) {
    measurement.p_QS = -middleOf(tool, step) * toolAxisInTool(arm);
    const Vector2d lean = toolLean(arm, X_WB, measurement).value_or(Vector2d::Zero());
    if (!all_entered) play = std::min(lean.norm(), 1.) * tool.lengths[step] / 2;
  }
  measurement.own[1] = all_entered ? 0 : std::max(tool.steps[step].tolerance - play, 0.);
  measurement.own[2] = entered > 0 ? tool.steps[entered - 1].tolerance + play : kNoBound;
  measurement.sigma = steps::sigmaBetween(measurement.own[1], measurement.own[2]);
}

}  // namespace tubeplan::calibration
