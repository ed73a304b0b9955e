// Batches of postures of one arm and of their tips, as plain tables.
//
// Values are laid out variable by variable: all readings of the first joint, then all of the second, and so on.
#pragma once

#include <vector>

#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::deflection {

using Side = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Batch of postures, one per column.
struct PostureBatch {
  Side q;                ///< readings [rad, m], one row for each joint
  Eigen::VectorXd load;  ///< [N]
  Side gravity_B;        ///< direction of gravity in the base: 3 rows, unit length

  /// Resizes to `count` postures with the same load [N] and gravity; the caller fills in the readings.
  void resize(Eigen::Index joints, Eigen::Index count, double load_of_all = 0,
              const Eigen::Vector3d& gravity_of_all = -Eigen::Vector3d::UnitZ());
  [[nodiscard]] Eigen::Index size() const { return q.cols(); }
};

/// Tips, one column for each posture; NaN if the posture does not converge.
struct TipBatch {
  std::vector<KinematicsStatus> status;
  Side poses;  ///< 12 rows: p_BD, then the columns of R_BD, in the nominal base
  /// 6 rows for each joint or variable: d p_BD [m per unit], then the rotation vector [rad per unit], in base axes.
  Side jacobian;

  [[nodiscard]] PoseOf<double> X_BD(Eigen::Index k) const;
};

}  // namespace tubeplan::deflection
