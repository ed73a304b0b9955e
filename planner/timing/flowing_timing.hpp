// A polyline travelled without rest at its inner waypoints: straight stretches at constant speed, joined by parabolas
// that cut the corners (linear segments with parabolic blends: Paul, Robot Manipulators, 1981, chapter 5).
//
// A parabola lasts b and begins and ends b/2 from the waypoint's time; it is at most |v' - v| b / 8 from the corner.
// The arm moves, and is proved free, along chords of the parabolas: rows of a path are joined by straight lines.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "planner/timing/trapezoid_timing.hpp"

namespace tubeplan::planner {

/// A phase of constant acceleration, from `start` until the next phase.
struct FlowPhase {
  double start = 0, duration = 0;             ///< [s]
  Eigen::VectorXd from, speed, acceleration;  ///< rad, rad/s, rad/s^2 (m for a slide)

  [[nodiscard]] Eigen::VectorXd at(double time_in_phase) const;
};

struct TimedFlow {
  std::vector<FlowPhase> phases;
  Eigen::VectorXd end;
  double duration = 0;  ///< [s]
};

/// Times a flow from rest at the first waypoint to rest at the last, with no joint beyond its limits. There must be one
/// waypoint or more; a single one gives a flow without phases. Asserts that the limits are usable
/// (findSpeedProblems()).
[[nodiscard]] TimedFlow timeFlow(const std::vector<Eigen::VectorXd>& waypoints, const JointSpeeds& speeds);

/// Returns postures at most `max_step` [s] apart, evenly within each straight phase, and at the ends of the chords of
/// each curved one. Times are strictly increasing; empty for a flow without phases.
[[nodiscard]] std::vector<TimedPosture> sampleFlow(const TimedFlow& flow, double max_step);

/// Returns the postures between which the samples are straight, for any step: ends of phases and of chords.
[[nodiscard]] std::vector<Eigen::VectorXd> cornersOf(const TimedFlow& flow);

}  // namespace tubeplan::planner
