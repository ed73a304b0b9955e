// Section of a stepped tool whose offset a count of steps bounds.
//
// A step enters if both of its ends are within its tolerance of the hole's axis (tubesheets/stepped_tool.hpp). For a
// tool with lengths, the count measures the middle of the first step that stayed out, or of the last step if all of
// them entered. The offset there is outside the tolerance of the step that stayed out and within that of the step
// before it, both up to half a step's length times the tool's tilt.
#pragma once

#include <optional>

#include "calibration/measurement.hpp"
#include "deflection/arm.hpp"
#include "tubesheets/stepped_tool.hpp"

namespace tubeplan::calibration {

/// The tool's axis, from the shank to the tip, at a measurement: unit vectors in the world frame and in the tool frame.
struct ToolAxis {
  Eigen::Vector3d axis_W, axis_T;

  [[nodiscard]] bool isUpward() const { return axis_W.z() > 0; }
  /// Returns how far the axis moves sideways per unit length upwards.
  [[nodiscard]] Eigen::Vector2d lean() const { return axis_W.head<2>() / axis_W.z(); }
};

/// Returns the tool's axis for a base at `X_WB`; empty if the deflected shape does not converge.
[[nodiscard]] std::optional<ToolAxis> toolAxisAt(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                                 const Measurement& measurement);

/// Sets the counted section of a measurement of kind `steps`, the bounds of the offset there, and sigma, for the number
/// of steps in kind_values[0], which the tool must have. The tilt is that of `arm` on a base at `X_WB`. A measurement
/// that states the measured point itself keeps it, and is taken as a count of an upright tool.
void settleCount(Measurement& measurement, const tubesheets::SteppedTool& tool, const deflection::Arm& arm,
                 const Eigen::Isometry3d& X_WB);

}  // namespace tubeplan::calibration
