// Which holes to touch so that the base is known best where the work is.
#pragma once

#include <string>
#include <vector>

#include "calibration/simulation/simulated_touch.hpp"

namespace tubeplan::calibration {

struct TouchChoiceOptions {
  int count = 3;
  double sigma = 1.27e-4;  ///< m, centring noise of each coordinate
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
/// one.
[[nodiscard]] TouchChoice chooseTouches(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                        const std::vector<TouchPlan>& candidates,
                                        const std::vector<Eigen::VectorXd>& work,
                                        const TouchChoiceOptions& options = {});

}  // namespace tubeplan::calibration
