// A polyline travelled without stops at its inner waypoints: straight segments at constant speed, connected by
// parabolas that cut the corners (linear segments with parabolic blends: Paul, Robot Manipulators, 1981, chapter 5).
//
// A parabola of duration b begins b/2 before the waypoint's time and ends b/2 after it. Its distance from the corner is
// at most |v' - v| b / 8, with speeds v before and v' after the corner. The arm moves, and is proved free, along chords
// of the parabolas, because consecutive samples of a path are connected by straight lines.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "planner/timing/trapezoid_timing.hpp"

namespace tubeplan::planner {

/// A phase of the motion with constant acceleration, from `start` until the next phase.
struct FlowPhase {
  double start = 0, duration = 0;  ///< start time and duration of the phase [s]
  /// Joint values at the start [rad], speeds there [rad/s] and accelerations [rad/s^2] (m for a prismatic joint).
  Eigen::VectorXd from, speed, acceleration;

  [[nodiscard]] Eigen::VectorXd at(double time_in_phase) const;
};

struct TimedFlow {
  std::vector<FlowPhase> phases;
  Eigen::VectorXd end;
  double duration = 0;  ///< duration of the whole motion [s]
};

/// Times a motion from rest at the first waypoint to rest at the last, within the limits of all joints. There must be
/// at least one waypoint; a single waypoint gives a flow without phases. Asserts that the limits are usable
/// (findSpeedProblems()).
[[nodiscard]] TimedFlow timeFlow(const std::vector<Eigen::VectorXd>& waypoints, const JointSpeeds& speeds);

/// Returns postures at most `max_step` [s] apart, evenly spaced within each straight phase, and at the ends of the
/// chords of each curved phase. Times are strictly increasing. Empty for a flow without phases.
[[nodiscard]] std::vector<TimedPosture> sampleFlow(const TimedFlow& flow, double max_step);

/// Returns the postures at the ends of all phases and chords. Samples with any `max_step` lie on the straight lines
/// between these postures.
[[nodiscard]] std::vector<Eigen::VectorXd> cornersOf(const TimedFlow& flow);

}  // namespace tubeplan::planner
