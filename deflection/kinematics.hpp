// Flexible kinematics of one arm for any number of postures: deflected tips and their exact derivatives, as many side
// by side as the processor has lanes. Where its rows are: row_placing.hpp. From goals back to postures:
// inverse/inverse_solver.hpp.
//
// Each posture's shape has the same bits as PreparedArm gives it, whatever its neighbours and whatever the processor.
#pragma once

#include <optional>
#include <vector>

#include "deflection/posture_batch.hpp"
#include "deflection/tip_differentiation.hpp"

namespace tubeplan::deflection {

/// Each thread needs its own. Arms that no kernel takes (effects, slides, clearances, elements that give about several
/// axes) are solved posture by posture, with the same results: nobody else asks which way an arm goes.
class Kinematics {
 public:
  /// `arm` must outlive this, and stay as it is.
  explicit Kinematics(const Arm& arm);

  /// Every posture on its own: one that fails fails alone. Nothing is taken from the heap where `tips` has held as many
  /// before and a kernel does the work.
  void solve(const PostureBatch& postures, TipBatch& tips, const FlexibleKinematicsOptions& options = {});
  void solveWithJacobian(const PostureBatch& postures, TipBatch& tips, const FlexibleKinematicsOptions& options = {});

  /// The same with derivatives by other variables than the joints.
  void solveWithDerivatives(const PostureBatch& postures, const std::vector<Variable>& variables, TipBatch& tips,
                            const FlexibleKinematicsOptions& options = {});

 private:
  [[nodiscard]] bool hasKernel(const std::vector<Variable>& variables);
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
