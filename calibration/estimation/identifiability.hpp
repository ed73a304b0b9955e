// Verdict for each free parameter on whether the measurements determine it, or only its prior does.
//
// Let C be the posterior covariance of the variables and J the whitened Jacobian of the measurements. A parameter's
// sigma is sqrt(C_kk) if all others are free, and 1 / sqrt(|J_k|^2 + 1 / s_k^2) if all others are known, where s_k is
// the sigma of its prior. A parameter is identifiable if the first sigma is well below s_k. If only the second is, the
// measurements determine the parameter only in combination with those parameters whose errors are correlated with its
// own.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

enum class Identifiability { kYes, kInCombination, kNo };

struct NumberIdentifiability {
  Identifiability verdict = Identifiability::kNo;
  /// For kInCombination: indices of the unknowns with which the errors of this one are correlated, strongest first.
  std::vector<int> with;
};

/// Returns a verdict for each unknown; `at` holds the variables' values at the optimum.
[[nodiscard]] std::vector<NumberIdentifiability> judgeIdentifiability(const Eigen::MatrixXd& jacobian,
                                                                      const Eigen::MatrixXd& covariance,
                                                                      const std::vector<Unknown>& unknowns,
                                                                      const Eigen::VectorXd& at);

}  // namespace tubeplan::calibration
