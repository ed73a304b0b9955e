// Choice of the holes to touch so that the tip is known best at the work postures, for an arm with uncertain
// parameters.
//
// Let B and Z be the whitened Jacobians of all rows of some touches with respect to the base and the parameters
// (independent standard normal variables). The touches' information on the base is F = B^T V^-1 B with V = I + Z Z^T.
// The position of a tip with Jacobians T and U has the error covariance
//     (T - U Z^T V^-1 B) F^-1 (T - U Z^T V^-1 B)^T + U (I - Z^T V^-1 Z) U^T.
// Its largest matrices have three rows per touch; their blocks are computed once for every pair of holes.
#pragma once

#include <string>
#include <vector>

#include "calibration/design/optimal_design.hpp"
#include "calibration/estimation/estimate.hpp"
#include "calibration/simulation/simulated_touch.hpp"

namespace tubeplan::calibration {

struct TouchChoiceOptions {
  int count = 3;
  double sigma = 1.27e-4;  ///< centring noise of each coordinate [m]
  DoubtBeside doubt = {};  ///< prior uncertainty of the arm, which the fit of the touches takes into account
};

enum class TouchChoiceStatus { kNotRun, kDone, kTooFewCandidates, kNotDetermined };

struct TouchChoice {
  TouchChoiceStatus status = TouchChoiceStatus::kNotRun;
  std::string reason;
  std::vector<int> chosen;  ///< indices of the chosen candidates
  /// Predicted standard deviation of a tip coordinate, root mean square over the work postures [m].
  double mean_sigma = std::numeric_limits<double>::quiet_NaN();
};

/// Chooses the best three touches (smallest mean variance of the tip over the work postures), then the best further
/// touches one by one. The problem's variables are the six of the base, then nuisance variables: independent standard
/// normal variables on which there are no readings yet. Every candidate has three rows.
[[nodiscard]] TouchChoice chooseTouches(const DesignProblem& problem, int count);

/// Chooses touches for an arm whose base is near X_WB and not yet calibrated, so that the tip is known best at the work
/// postures without load.
[[nodiscard]] TouchChoice chooseTouches(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                        const std::vector<TouchPlan>& candidates,
                                        const std::vector<Eigen::VectorXd>& work,
                                        const TouchChoiceOptions& options = {});

}  // namespace tubeplan::calibration
