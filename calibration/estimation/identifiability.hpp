// Information of the readings on each free parameter, compared with its prior.
//
// Let C be the posterior covariance of the variables and J the whitened Jacobian of the readings. A parameter's sigma
// is sqrt(C_kk) if all others are free, and 1 / sqrt(|J_k|^2 + 1 / s_k^2) if all others are known, where s_k is the
// sigma of its prior. A parameter is identifiable if the first sigma is well below that of its prior. If only the
// second is, the readings determine the parameter in combination with those that its error is correlated with.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

enum class Identifiability { kYes, kInCombination, kNo };

struct NumberIdentifiability {
  Identifiability verdict = Identifiability::kNo;
  /// Indices of the unknowns in combination with which the readings determine this one, strongest correlation first.
  std::vector<int> with;
};

/// Returns a verdict for each unknown; `at` holds the variables' values at the optimum.
[[nodiscard]] std::vector<NumberIdentifiability> judgeIdentifiability(const Eigen::MatrixXd& jacobian,
                                                                      const Eigen::MatrixXd& covariance,
                                                                      const std::vector<Unknown>& unknowns,
                                                                      const Eigen::VectorXd& at);

}  // namespace tubeplan::calibration
