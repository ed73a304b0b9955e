// Which holes to touch so that the base is known best where the work is, beside an arm whose numbers are uncertain.
//
// With B and Z the whitened slopes of all rows of some touches by base and numbers (independent standard normals), what
// the touches tell of the base is F = B^T V^-1 B with V = I + Z Z^T. The errors of a tip with slopes T and U are
//     (T - U Z^T V^-1 B) F^-1 (T - U Z^T V^-1 B)^T + U (I - Z^T V^-1 Z) U^T:
// matrices of three rows a touch, put together of blocks that are made once for every pair of holes.
#pragma once

#include <string>
#include <vector>

#include "calibration/design/optimal_design.hpp"
#include "calibration/estimation/estimate.hpp"
#include "calibration/simulation/simulated_touch.hpp"

namespace tubeplan::calibration {

struct TouchChoiceOptions {
  int count = 3;
  double sigma = 1.27e-4;  ///< m, centring noise of each coordinate
  DoubtBeside doubt = {};  ///< of the arm, beside which the touches will be fitted
};

enum class TouchChoiceStatus { kNotRun, kDone, kTooFewCandidates };

struct TouchChoice {
  TouchChoiceStatus status = TouchChoiceStatus::kNotRun;
  std::string reason;
  std::vector<int> chosen;                                       ///< indices of the candidates
  double mean_sigma = std::numeric_limits<double>::quiet_NaN();  ///< predicted sigma of a tip coordinate, root mean
                                                                 ///< square over the work [m]
};

/// The best triple of all (least mean variance of the tip over the work postures), then the best further hole one by
/// one. The problem's variables are the base's six, then those beside it as independent standard normals of which no
/// reading tells anything yet; every candidate has three rows.
[[nodiscard]] TouchChoice chooseTouches(const DesignProblem& problem, int count);

/// Chooses touches for an arm that stands near X_WB, nothing being touched yet. Its tip shall be known in the postures
/// of the work, under no load.
[[nodiscard]] TouchChoice chooseTouches(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                        const std::vector<TouchPlan>& candidates,
                                        const std::vector<Eigen::VectorXd>& work,
                                        const TouchChoiceOptions& options = {});

}  // namespace tubeplan::calibration
