// Plan as a trajectory for a robot controller.
#pragma once

#include <string>

#include "app/documents/plan_outcome.hpp"

namespace tubeplan::app {

inline constexpr const char* kTrajectoryFile = "trajectory.yaml";

/// Throws InputError for an arm with a joint of unlimited acceleration: the joint's speed would jump, and a controller
/// with cubic interpolation would leave the planned lines.
void requireAccelerations(const deflection::Arm& arm);

/// Returns a trajectory_msgs/JointTrajectory of ROS 2 as YAML: joint_names, and points with positions, velocities,
/// accelerations and time_from_start. Units are radians (metres for a prismatic joint) and seconds, regardless of the
/// cell's units. Each time exceeds the previous one by at least a microsecond. Throws InputError as
/// requireAccelerations() does.
[[nodiscard]] std::string trajectoryYaml(const PlanOutcome& outcome);

}  // namespace tubeplan::app
