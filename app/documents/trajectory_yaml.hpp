// A plan as a robot controller takes it.
#pragma once

#include <string>

#include "app/documents/plan_outcome.hpp"

namespace tubeplan::app {

inline constexpr const char* kTrajectoryFile = "trajectory.yaml";

/// Refuses an arm with a joint whose acceleration is unlimited: its speed would jump, and a cubic through points with
/// speeds would leave the planned lines.
void requireAccelerations(const deflection::Arm& arm);

/// trajectory_msgs/JointTrajectory of ROS 2 as YAML: joint_names, points with positions, velocities, accelerations and
/// time_from_start. Radians (metres for a sliding joint) and seconds, whatever the cell's units. Times rise by a
/// microsecond or more. Throws InputError as requireAccelerations() does.
[[nodiscard]] std::string trajectoryYaml(const PlanOutcome& outcome);

}  // namespace tubeplan::app
