// Plan in the form for a robot controller.
#pragma once

#include <string>

#include "app/documents/plan_outcome.hpp"

namespace tubeplan::app {

inline constexpr const char* kTrajectoryFile = "trajectory.yaml";

/// Throws InputError for an arm with a joint of unlimited acceleration: its speed would jump, and a cubic through
/// points with speeds would leave the planned lines.
void requireAccelerations(const deflection::Arm& arm);

/// Returns trajectory_msgs/JointTrajectory of ROS 2 as YAML: joint_names, points with positions, velocities,
/// accelerations and time_from_start. Radians (metres for a sliding joint) and seconds, whatever the cell's units.
/// Times rise by a microsecond or more. Throws InputError as requireAccelerations() does.
[[nodiscard]] std::string trajectoryYaml(const PlanOutcome& outcome);

}  // namespace tubeplan::app
