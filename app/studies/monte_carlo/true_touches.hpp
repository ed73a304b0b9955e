// Holes as a drawn true arm touches them: its error beyond any model belongs to the posture, so that a hole that is
// touched and visited has the same error both times.
#pragma once

#include <vector>

#include "calibration/estimation/base_calibration.hpp"
#include "calibration/simulation/simulated_touch.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// A hole, the posture that reaches it, and what the true arm does there beyond its own model.
struct TrialHole {
  calibration::TouchPlan plan;
  int tube = -1;                                        ///< index in the sheet
  Eigen::Vector3d tip_error = Eigen::Vector3d::Zero();  ///< m
};

/// What the true arm reads when it touches the first `count` of the holes, each coordinate of a centring off by
/// `sigma` [m]. Empty where one is out of its reach.
[[nodiscard]] std::vector<calibration::Measurement> touchHoles(const planner::Workcell& truth,
                                                               const std::vector<TrialHole>& holes, int count,
                                                               double sigma, std::uint64_t seed);

inline constexpr int kMostDraws = 1000;  ///< of holes to touch, until some lie well off a line

/// Whether the first `count` holes lie well off a line: a line of them would place no base.
[[nodiscard]] bool areWellSpread(const std::vector<TrialHole>& holes, int count);

}  // namespace tubeplan::app
