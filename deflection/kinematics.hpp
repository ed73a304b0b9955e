// Flexible kinematics of one arm for any number of postures: deflected tips and their exact derivatives. Computes as
// many postures at once as the processor has SIMD lanes. See row_placing.hpp for the frames of the arm's rows, and
// inverse/inverse_solver.hpp for postures that reach goals.
//
// The shape of a posture is bit-identical to that of PreparedArm on every processor, regardless of the postures in the
// other lanes.
#pragma once

#include <optional>
#include <vector>

#include "deflection/posture_batch.hpp"
#include "deflection/tip_differentiation.hpp"

namespace tubeplan::deflection {

/// Forward kinematics of many postures; each thread needs its own object. Arms that no kernel can solve (those with
/// effects, prismatic joints, clearances, or elements that are compliant about several axes) are solved posture by
/// posture. Callers see no difference.
class Kinematics {
 public:
  /// `arm` must outlive this object, and must not change.
  explicit Kinematics(const Arm& arm);

  /// Solves every posture independently: a posture that fails does not affect the others. Does not allocate memory if a
  /// kernel solves the arm and `tips` already has capacity for the batch.
  void solve(const PostureBatch& postures, TipBatch& tips, const FlexibleKinematicsOptions& options = {});
  void solveWithJacobian(const PostureBatch& postures, TipBatch& tips, const FlexibleKinematicsOptions& options = {});

  /// Solves with derivatives with respect to variables other than the joints.
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
  std::optional<TipDifferentiation> tip_;  ///< differentiation of the tip, used if there is no kernel
  std::vector<Variable> joints_;
  std::vector<double> sweeps_, derivatives_;
};

}  // namespace tubeplan::deflection
