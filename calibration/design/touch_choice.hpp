// Choice of the holes to touch so that the base is known best at the work, for an arm with uncertain numbers.
//
// With B and Z the whitened slopes of all rows of some touches by base and numbers (independent standard normals), the
// touches' information on the base is F = B^T V^-1 B with V = I + Z Z^T. The errors of a tip with slopes T and U are
//     (T - U Z^T V^-1 B) F^-1 (T - U Z^T V^-1 B)^T + U (I - Z^T V^-1 Z) U^T:
// matrices of three rows a touch, assembled from blocks that are computed once for every pair of holes.
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
  DoubtBeside doubt = {};  ///< doubt of the arm, with which the touches will be fitted
};

enum class TouchChoiceStatus { kNotRun, kDone, kTooFewCandidates };

struct TouchChoice {
  TouchChoiceStatus status = TouchChoiceStatus::kNotRun;
  std::string reason;
  std::vector<int> chosen;  ///< indices of the candidates
  /// Predicted sigma of a tip coordinate, root mean square over the work [m].
  double mean_sigma = std::numeric_limits<double>::quiet_NaN();
};

/// Chooses the best triple of all (least mean variance of the tip over the work postures), then the best further holes
/// one by one. The problem's variables are the base's six, then nuisance variables as independent standard normals
/// without earlier readings; every candidate has three rows.
[[nodiscard]] TouchChoice chooseTouches(const DesignProblem& problem, int count);

/// Chooses touches for an arm that stands near X_WB, before any touch. Its tip is to be known in the postures of the
/// work, under no load.
[[nodiscard]] TouchChoice chooseTouches(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                        const std::vector<TouchPlan>& candidates,
                                        const std::vector<Eigen::VectorXd>& work,
                                        const TouchChoiceOptions& options = {});

}  // namespace tubeplan::calibration
