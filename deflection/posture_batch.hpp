// Many postures of one arm at once, as many side by side as the processor has lanes.
//
// Numbers are laid out kind by kind: all readings of the first joint, then all of the second, and so on. Each posture's
// shape has the same bits as PreparedArm gives it, whatever its neighbours and whatever the processor.
#pragma once

#include <optional>
#include <vector>

#include "deflection/tip_differentiation.hpp"

namespace tubeplan::deflection {

using Side = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// One column for each posture.
struct PostureBatch {
  Side q;                ///< readings [rad, m], one row for each joint
  Eigen::VectorXd load;  ///< N
  Side gravity_B;        ///< 3 rows, unit length

  /// For `count` postures under one load and gravity; readings are to be filled in.
  void resize(Eigen::Index joints, Eigen::Index count, double load_of_all = 0,
              const Eigen::Vector3d& gravity_of_all = -Eigen::Vector3d::UnitZ());
  [[nodiscard]] Eigen::Index size() const { return q.cols(); }
};

/// One column for each posture; not numbers where it does not converge.
struct TipBatch {
  std::vector<KinematicsStatus> status;
  Side poses;     ///< 12 rows: p_BD, then the columns of R_BD, in the base as named
  Side jacobian;  ///< 6 rows for each joint, or variable: d p_BD [m per unit], then the rotation vector [rad per unit],
                  ///< base axes

  [[nodiscard]] PoseOf<double> X_BD(Eigen::Index k) const;
};

/// Solves batches of one arm; each thread needs its own. An arm that is no case for a kernel (effects, slides,
/// clearances, elements that give about several axes) is solved posture by posture, with the same results.
class BatchKinematics {
 public:
  /// `arm` must outlive this, and stay as it is.
  explicit BatchKinematics(const Arm& arm);

  /// Every posture on its own: one that fails fails alone. Nothing is taken from the heap where `tips` has held as many
  /// before and a kernel does the work.
  void solve(const PostureBatch& postures, TipBatch& tips, const FlexibleKinematicsOptions& options = {});
  void solveWithJacobian(const PostureBatch& postures, TipBatch& tips, const FlexibleKinematicsOptions& options = {});

  /// The same with derivatives by other variables than the joints.
  void solveWithDerivatives(const PostureBatch& postures, const std::vector<Variable>& variables, TipBatch& tips,
                            const FlexibleKinematicsOptions& options = {});

  /// Whether a kernel does the work for derivatives by these, too; for none, whether it does for shapes.
  [[nodiscard]] bool hasKernel(const std::vector<Variable>& variables);

  /// The lanes of the kernel that does the work, 1 where none does.
  [[nodiscard]] int lanes() const;

 private:
  void run(const PostureBatch& postures, TipBatch& tips, const FlexibleKinematicsOptions& options,
           const std::vector<Variable>& variables);
  void solveSideBySide(const PostureBatch& postures, TipBatch& tips, const FlexibleKinematicsOptions& options,
                       const std::vector<Variable>& variables);
  void solveOneByOne(const PostureBatch& postures, TipBatch& tips, const FlexibleKinematicsOptions& options,
                     const std::vector<Variable>& variables);

  const Arm& given_;
  PreparedArm arm_;
  std::optional<TipDifferentiation> tip_;  ///< where no kernel does the work
  std::vector<Variable> joints_;
  std::vector<double> sweeps_, derivatives_;
};

}  // namespace tubeplan::deflection
