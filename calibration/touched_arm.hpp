// An arm made ready for many tips in the world: a base is found by solving its touches again and again.
#pragma once

#include <vector>

#include "calibration/base_residual.hpp"
#include "deflection/tip_differentiation.hpp"

namespace tubeplan::calibration {

/// Each thread needs its own.
class TouchedArm {
 public:
  /// `arm` must outlive this, and stay as it is.
  explicit TouchedArm(const deflection::Arm& arm);

  [[nodiscard]] const deflection::Arm& arm() const { return arm_; }

  /// As tipInWorld() of the arm.
  [[nodiscard]] TipInWorld tipInWorld(const Eigen::Isometry3d& X_WB, const Eigen::VectorXd& q, double load);

  /// The deflected tip in the base; NaN where the shape does not settle and `must_settle`.
  [[nodiscard]] Eigen::Vector3d tipInBase(const Eigen::Isometry3d& X_WB, const Touch& touch,
                                          const deflection::FlexibleKinematicsOptions& options, bool must_settle);

 private:
  const deflection::Arm& arm_;
  std::vector<deflection::Variable> variables_;  ///< the joints, then gravity turned about the base's axes
  deflection::TipDifferentiation tips_;
  deflection::PreparedArm shapes_;
};

}  // namespace tubeplan::calibration
