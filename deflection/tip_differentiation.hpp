// The deflected tip of one arm and its exact derivatives, for one posture after another.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "deflection/direct_changes.hpp"
#include "deflection/prepared_arm.hpp"
#include "deflection/revolute_chain/revolute_variables.hpp"
#include "deflection/tip_derivatives.hpp"
#include "deflection/tip_sensitivity.hpp"

namespace tubeplan::deflection {

/// Solves shapes of one arm with their derivatives, one posture after another; each thread needs its own object.
class TipDifferentiation {
 public:
  /// `arm` must outlive this object, and must not change.
  explicit TipDifferentiation(const Arm& arm);
  TipDifferentiation(const TipDifferentiation&) = delete;
  TipDifferentiation& operator=(const TipDifferentiation&) = delete;

  /// Solves the shape and, if it converges, its derivatives with respect to `variables`; otherwise columns() is NaN.
  KinematicsStatus solve(const Posture& posture, const std::vector<Variable>& variables,
                         const FlexibleKinematicsOptions& options = {});

  /// Solves for the deflected frame of a row instead of the tool frame: columns() then holds the derivatives of that
  /// frame's position and rotation, which are also exact. Slower than solve() if a kernel computes derivatives of the
  /// tool frame.
  KinematicsStatus solveRow(int row, const Posture& posture, const std::vector<Variable>& variables,
                            const FlexibleKinematicsOptions& options = {});

  [[nodiscard]] const PreparedArm& arm() const { return arm_; }
  /// Returns d p_BD / d variable [m per unit], then the rotation vector of the tool frame [rad per unit], in base axes,
  /// one column for each variable. After solveRow() the columns describe the row's frame.
  [[nodiscard]] const Eigen::Matrix<double, 6, Eigen::Dynamic>& columns() const { return columns_; }

 private:
  using Block = std::array<std::size_t, kDualSize>;  ///< indices of the variables that are differentiated in one pass

  KinematicsStatus solveByKernel(const Posture& posture, const simd::RevoluteVariables& kernel,
                                 const FlexibleKinematicsOptions& options);
  KinematicsStatus settle(std::size_t variables);
  void differentiate(int row, const Posture& posture, const std::vector<Variable>& variables);
  void castPosture(const Posture& posture);
  void turnWorld();
  void seed(const Variable& variable, int slot, double size);
  void differentiateFollowers(std::size_t but, TipColumns& tip);
  void differentiateWithoutEffects(const std::vector<Variable>& variables);
  bool differentiateRow(std::size_t index, ArmOf<Dual>& arm, const Dual& q, bool leads_elsewhere, TipColumns& tip);
  void differentiateWithEffects(const std::vector<Variable>& variables);
  void differentiateInContext(TipColumns& tip);
  void moveBase(TipColumns& tip) const;
  void store(const Block& block, int count, const TipColumns& tip);
  [[nodiscard]] Dual readingOf(std::size_t row, const Eigen::Matrix<Dual, Eigen::Dynamic, 1>& q) const;

  const Arm& given_;
  PreparedArm arm_;
  TipSensitivity sensitivity_;
  DirectChanges direct_;
  std::vector<double> kernel_columns_;
  ArmOf<Dual> dual_arm_;  ///< the arm in dual numbers, empty until needed
  PostureOf<Dual> dual_posture_;
  Vector3<Dual> gravity_turn_;
  std::optional<EffectContext<Dual>> context_;  ///< effects of the dual arm and posture; empty if there are none
  std::vector<int> joints_;                     ///< joint index of each row; -1 if the row is passive
  std::vector<int> active_;                     ///< row index of each joint
  std::vector<std::pair<int, std::size_t>> order_;
  Eigen::Matrix<double, 6, Eigen::Dynamic> columns_;
};

}  // namespace tubeplan::deflection
