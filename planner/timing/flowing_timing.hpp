// A polyline travelled without rest at its inner waypoints: straight stretches at constant speed, joined by parabolas
// that cut the corners (linear segments with parabolic blends: Paul, Robot Manipulators, 1981, chapter 5).
//
// A parabola lasts b and begins and ends b/2 from the waypoint's time; at most |v' - v| b / 8 parts it from the corner.
// What is driven, and so what is to be proved, are chords of the parabolas: rows of a path are joined by straight
// lines.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "planner/timing/trapezoid_timing.hpp"

namespace tubeplan::planner {

/// From `start` on, until the next phase: constant acceleration.
struct FlowPhase {
  double start = 0, duration = 0;             ///< s
  Eigen::VectorXd from, speed, acceleration;  ///< rad, rad/s, rad/s^2 (m for a slide)

  [[nodiscard]] Eigen::VectorXd at(double time_in_phase) const;
};

struct TimedFlow {
  std::vector<FlowPhase> phases;
  Eigen::VectorXd end;
  double duration = 0;  ///< s
};

/// From rest at the first waypoint to rest at the last, no joint beyond its limits. At least one waypoint; a single one
/// gives a flow without phases. Asserts that the limits are usable (`findSpeedProblems`).
[[nodiscard]] TimedFlow timeFlow(const std::vector<Eigen::VectorXd>& waypoints, const JointSpeeds& speeds);

/// Postures at most `max_step` [s] apart, evenly within each straight phase, and at the ends of the chords of each
/// curved one. Times rise strictly; empty for a flow without phases.
[[nodiscard]] std::vector<TimedPosture> sampleFlow(const TimedFlow& flow, double max_step);

/// The postures between which the samples run straight, whatever their step: ends of phases and of chords.
[[nodiscard]] std::vector<Eigen::VectorXd> cornersOf(const TimedFlow& flow);

}  // namespace tubeplan::planner
