#include "calibration/design/touch_choice.hpp"

#include <algorithm>
#include <cmath>

#include "calibration/measurements/reading_prediction.hpp"

namespace tubeplan::calibration {

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

Matrix6 informationOf(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const TouchPlan& candidate,
                      double sigma) {
  const Prediction tip = predictTip(arm, X_WB, candidate.q_start, 0);
  const Eigen::Matrix3d centring = sigma * sigma * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d weight = (centring + encoderCovariance(arm, tip.by_joints)).inverse();
  return tip.by_base.transpose() * weight * tip.by_base;
}

/// Sum over the work of J^T J: the mean variance is then the trace of this against the base's covariance.
Matrix6 workSensitivity(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                        const std::vector<Eigen::VectorXd>& work) {
  Matrix6 sum = Matrix6::Zero();
  for (const auto& q : work) {
    const Prediction tip = predictTip(arm, X_WB, q, 0);
    sum += tip.by_base.transpose() * tip.by_base / (3. * static_cast<double>(work.size()));
  }
  return sum;
}

double variance(const Matrix6& information, const Matrix6& work) {
  const Eigen::LDLT<Matrix6> factor(information);
  if (factor.vectorD().minCoeff() <= 1e-12 * factor.vectorD().maxCoeff())
    return std::numeric_limits<double>::infinity();
  return factor.solve(work).trace();
}

}  // namespace

TouchChoice chooseTouches(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                          const std::vector<TouchPlan>& candidates, const std::vector<Eigen::VectorXd>& work,
                          const TouchChoiceOptions& options) {
  TouchChoice result;
  const int n = static_cast<int>(candidates.size());
  if (n < options.count || options.count < 3) {
    result.status = TouchChoiceStatus::kTooFewCandidates;
    result.reason =
        std::to_string(n) + " holes can be touched, " + std::to_string(options.count) + " (at least 3) are asked for";
    return result;
  }
  std::vector<Matrix6> information;
  for (const auto& candidate : candidates) information.push_back(informationOf(arm, X_WB, candidate, options.sigma));
  const Matrix6 sensitivity = workSensitivity(arm, X_WB, work);
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j)
      for (int k = j + 1; k < n; ++k)
        if (const double v = variance(information[i] + information[j] + information[k], sensitivity); v < best) {
          best = v;
          result.chosen = {i, j, k};
        }
  Matrix6 total = Matrix6::Zero();
  for (int index : result.chosen) total += information[index];
  while (static_cast<int>(result.chosen.size()) < options.count) {
    int next = -1;
    best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < n; ++i) {
      if (std::find(result.chosen.begin(), result.chosen.end(), i) != result.chosen.end()) continue;
      if (const double v = variance(total + information[i], sensitivity); v < best) best = v, next = i;
    }
    if (next < 0) break;
    result.chosen.push_back(next);
    total += information[next];
  }
  result.mean_sigma = std::sqrt(best);
  result.status = TouchChoiceStatus::kDone;
  return result;
}

}  // namespace tubeplan::calibration
