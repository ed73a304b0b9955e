// Information of the readings on each free number beside its prior.
//
// With a posterior covariance C of the variables and J the whitened Jacobian of the readings, a number's sigma is
// sqrt(C_kk) when all others are free, and 1 / sqrt(|J_k|^2 + 1 / s_k^2) when all others are known (s_k its prior's
// sigma). A number is identifiable if the first is well below its prior's sigma; if only the second is, the readings
// determine it in combination with those that its error is correlated with.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

enum class Identifiability { kYes, kInCombination, kNo };

struct NumberIdentifiability {
  Identifiability verdict = Identifiability::kNo;
  std::vector<int> with;  ///< unknowns that it is determined in combination with, strongest correlation first
};

/// Returns a verdict for each unknown. `at` are the variables' values at the optimum.
[[nodiscard]] std::vector<NumberIdentifiability> judgeIdentifiability(const Eigen::MatrixXd& jacobian,
                                                                      const Eigen::MatrixXd& covariance,
                                                                      const std::vector<Unknown>& unknowns,
                                                                      const Eigen::VectorXd& at);

}  // namespace tubeplan::calibration
