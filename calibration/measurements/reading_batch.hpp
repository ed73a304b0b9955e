// The tips of many readings at once (deflection/kinematics.hpp).
#pragma once

#include <vector>

#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/placed_arm.hpp"
#include "deflection/kinematics.hpp"

namespace tubeplan::calibration {

/// Whether joints, load and gravity are all that matters to the model of any of the readings: arms without effects,
/// tips on which nothing but a load hangs. Readings of rows' frames are none for a batch: all that it knows is tips.
[[nodiscard]] bool isForBatch(const deflection::Arm& arm, const std::vector<Measurement>& readings);

/// Readings that one core takes at once.
inline constexpr std::size_t kReadingsOfCore = 128;

/// Of readings for which isForBatch() holds.
class ReadingBatch {
 public:
  /// `arm` must outlive this, and stay as it is.
  explicit ReadingBatch(const deflection::Arm& arm) : arm_(arm), kinematics_(arm) {}

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
  [[nodiscard]] Eigen::Matrix3d turn(std::size_t k) const {
    return tips_.X_BD(static_cast<Eigen::Index>(k)).R * toolFrame(arm_);
  }
  [[nodiscard]] Eigen::Vector3d turnColumn(std::size_t k, std::size_t variable) const {
    return tips_.jacobian.col(static_cast<Eigen::Index>(k)).segment<3>(6 * static_cast<Eigen::Index>(variable) + 3);
  }

 private:
  void place(const Measurement& reading, double load, const Eigen::Vector3d& gravity_B, Eigen::Index at);
  [[nodiscard]] Eigen::Vector3d columnAt(Eigen::Index posture, std::size_t variable) const {
    return tips_.jacobian.col(posture).segment<3>(6 * static_cast<Eigen::Index>(variable));
  }

  const deflection::Arm& arm_;
  deflection::Kinematics kinematics_;
  deflection::PostureBatch postures_;
  deflection::TipBatch tips_;
  std::vector<Eigen::Index> from_;  ///< the posture to take off, -1 where there is none
};

/// The tool of a reading in the world; of a deflection the tip's displacement.
[[nodiscard]] ToolPose toolOf(const ReadingBatch& batch, std::size_t k, const Eigen::Isometry3d& X_WB,
                              const Measurement& reading);

}  // namespace tubeplan::calibration
