// Choice of the holes to touch that minimise the uncertainty of the tip at the work postures, for an arm with uncertain
// parameters.
//
// Let B and Z be the whitened Jacobians of the touches with respect to the base and to the parameters (as independent
// standard normal variables). The information matrix of the base is F = B^T V^-1 B with V = I + Z Z^T. A tip position
// with Jacobians T and U with respect to the same variables has the error covariance
//     (T - U Z^T V^-1 B) F^-1 (T - U Z^T V^-1 B)^T + U (I - Z^T V^-1 Z) U^T.
// The largest matrices have three rows per touch. Their blocks are computed once for each pair of holes.
#pragma once

#include <string>
#include <vector>

#include "calibration/design/optimal_design.hpp"
#include "calibration/estimation/estimate.hpp"
#include "calibration/simulation/simulated_touch.hpp"

namespace tubeplan::calibration {

struct TouchChoiceOptions {
  int count = 3;
  double sigma = 1.27e-4;  ///< standard deviation of the centring noise of each coordinate [m]
  AdditionalUncertainty additional =
      {};  ///< prior uncertainty of the arm, which the fit of the touches takes into account
};

enum class TouchChoiceStatus { kNotRun, kDone, kTooFewCandidates, kNotDetermined };

struct TouchChoice {
  TouchChoiceStatus status = TouchChoiceStatus::kNotRun;
  std::string reason;
  std::vector<int> chosen;  ///< indices of the chosen candidates
  /// Predicted standard deviation of one tip coordinate [m]: root mean square over the work postures.
  double mean_sigma = std::numeric_limits<double>::quiet_NaN();
};

/// Chooses the three touches with the smallest mean variance of the tip over the work postures, then adds the best
/// further touches one by one. The variables of `problem` are the six of the base, then nuisance variables: independent
/// standard normal variables without any measurements so far. Every candidate has three rows.
[[nodiscard]] TouchChoice chooseTouches(const DesignProblem& problem, int count);

/// Chooses the touches that minimise the uncertainty of the unloaded tip at the work postures, for an arm whose base is
/// near X_WB but not yet calibrated.
[[nodiscard]] TouchChoice chooseTouches(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                        const std::vector<TouchPlan>& candidates,
                                        const std::vector<Eigen::VectorXd>& work,
                                        const TouchChoiceOptions& options = {});

}  // namespace tubeplan::calibration
