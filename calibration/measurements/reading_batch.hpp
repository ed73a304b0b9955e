// The tips of many readings at once, side by side where the arm is one for a kernel (deflection/posture_batch.hpp).
#pragma once

#include <vector>

#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/placed_arm.hpp"
#include "deflection/posture_batch.hpp"

namespace tubeplan::calibration {

/// Whether joints, load and gravity are all that matters to the model of any of the readings: arms without effects,
/// tips on which nothing but a load hangs. Readings of rows' frames are none for a batch: all that it knows is tips.
[[nodiscard]] bool isForBatch(const deflection::Arm& arm, const std::vector<Measurement>& readings);

/// Of readings for which isForBatch() holds.
class ReadingBatch {
 public:
  /// `arm` must outlive this, and stay as it is.
  explicit ReadingBatch(const deflection::Arm& arm) : arm_(arm), kinematics_(arm) {}

  /// Whether tips and their derivatives by `variables` come side by side.
  [[nodiscard]] bool isFastFor(const std::vector<deflection::Variable>& variables) {
    return kinematics_.hasKernel(variables);
  }

  /// Solves `count` readings from `first`, each at its base pose of `base_poses`; false where a shape does not
  /// converge. What follows is counted from `first`.
  bool solve(const std::vector<BasePose>& base_poses, const std::vector<Measurement>& readings,
             const std::vector<int>& base_pose_of, std::size_t first, std::size_t count,
             const std::vector<deflection::Variable>& variables);

  /// The tip as seen from the base [m], base axes; of a displacement less what it is taken from, as are its
  /// derivatives.
  [[nodiscard]] Eigen::Vector3d tip(std::size_t k) const;
  [[nodiscard]] Eigen::Vector3d column(std::size_t k, std::size_t variable) const;

  /// The derivative at the reading's own posture alone, or at the one that its displacement is taken from.
  [[nodiscard]] Eigen::Vector3d ownColumn(std::size_t k, std::size_t variable) const {
    return columnAt(static_cast<Eigen::Index>(k), variable);
  }
  [[nodiscard]] Eigen::Vector3d referenceColumn(std::size_t k, std::size_t variable) const {
    return columnAt(from_[k], variable);
  }

  /// The tool frame as seen from the base, and how it turns [rad], base axes; not of a deflection.
  [[nodiscard]] Eigen::Matrix3d turn(std::size_t k) const { return tips_.X_BD(static_cast<Eigen::Index>(k)).R; }
  [[nodiscard]] Eigen::Vector3d turnColumn(std::size_t k, std::size_t variable) const {
    return tips_.jacobian.col(static_cast<Eigen::Index>(k)).segment<3>(6 * static_cast<Eigen::Index>(variable) + 3);
  }

 private:
  void place(const Measurement& reading, double load, const Eigen::Vector3d& gravity_B, Eigen::Index at);
  [[nodiscard]] Eigen::Vector3d columnAt(Eigen::Index posture, std::size_t variable) const {
    return tips_.jacobian.col(posture).segment<3>(6 * static_cast<Eigen::Index>(variable));
  }

  const deflection::Arm& arm_;
  deflection::BatchKinematics kinematics_;
  deflection::PostureBatch postures_;
  deflection::TipBatch tips_;
  std::vector<Eigen::Index> from_;  ///< the posture to take off, -1 where there is none
};

/// The tool of a reading in the world; of a deflection the tip's displacement.
[[nodiscard]] ToolPose toolOf(const ReadingBatch& batch, std::size_t k, const Eigen::Isometry3d& X_WB,
                              const Measurement& reading);

}  // namespace tubeplan::calibration
