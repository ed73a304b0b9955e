// Touches of holes by a drawn true arm. Its error beyond any model belongs to the posture, so that a hole that is
// touched and visited has the same error both times.
#pragma once

#include <vector>

#include "calibration/estimation/base_calibration.hpp"
#include "calibration/simulation/simulated_touch.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// A hole, the posture that reaches it, and the error of the true arm there beyond its own model.
struct TrialHole {
  calibration::TouchPlan plan;
  int tube = -1;                                        ///< index in the sheet
  Eigen::Vector3d tip_error = Eigen::Vector3d::Zero();  ///< [m]
};

/// Returns the readings of the true arm when it touches the first `count` of the holes, with a centring error of
/// `sigma` [m] in each coordinate. Empty if one is out of its reach.
[[nodiscard]] std::vector<calibration::Measurement> touchHoles(const planner::Workcell& truth,
                                                               const std::vector<TrialHole>& holes, int count,
                                                               double sigma, std::uint64_t seed);

inline constexpr int kMostDraws = 1000;  ///< draws of holes to touch, until some lie well off a line

/// Returns true if the first `count` holes lie well off a line; holes on a line would not place a base.
[[nodiscard]] bool areWellSpread(const std::vector<TrialHole>& holes, int count);

}  // namespace tubeplan::app
