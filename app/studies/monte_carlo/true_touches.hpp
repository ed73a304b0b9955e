// Touches of holes by a drawn true arm. The unmodelled error of the arm depends only on the posture, so a hole that is
// touched and later visited has the same error both times.
#pragma once

#include <vector>

#include "calibration/estimation/base_calibration.hpp"
#include "calibration/simulation/simulated_touch.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// A hole, the posture that reaches it, and the unmodelled error of the true arm in this posture.
struct TrialHole {
  calibration::TouchPlan plan;
  int tube = -1;                                        ///< index in the tube sheet
  Eigen::Vector3d tip_error = Eigen::Vector3d::Zero();  ///< unmodelled error of the tip in the world frame [m]
};

/// Smallest standard deviation by which touches are weighted [m]; without noise the weights would be infinite.
inline constexpr double kLeastWeighingSigma = 1e-6;

/// Returns the true arm's measurements of touches of the first `count` holes, with a centring noise of `sigma` [m] in
/// each coordinate. Empty if one of the holes is out of reach.
[[nodiscard]] std::vector<calibration::Measurement> touchHoles(const planner::Workcell& truth,
                                                               const std::vector<TrialHole>& holes, int count,
                                                               double sigma, std::uint64_t seed);

inline constexpr int kMostDraws = 1000;  ///< largest number of draws to find holes far from collinear

/// Returns true if the first `count` holes are far from collinear; touches of collinear holes would not determine a
/// base.
[[nodiscard]] bool areWellSpread(const std::vector<TrialHole>& holes, int count);

}  // namespace tubeplan::app
