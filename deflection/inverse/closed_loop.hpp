// All readings of a rigid chain that meet a goal, found together: the roots of the chain's closure equations, from the
// eigenvalues of a matrix polynomial (Manocha and Canny 1994, "Efficient inverse kinematics for general 6R
// manipulators", IEEE Trans. Robot. Automat. 10). Three joints control a position, with at most four postures. Five
// joints control a position and an axis with free roll about the axis, with at most sixteen postures. Prismatic joints
// are treated in the same way as revolute joints.
//
// Parallel or intersecting axes would make matrices singular, so the axes are perturbed by a ten-thousandth of the
// reach and 1e-4 rad. The roots are then refined to postures of the unperturbed chain. Internal to the inverse
// kinematics.
#pragma once

#include <vector>

#include "deflection/inverse/loop_closure.hpp"

namespace tubeplan::deflection {

/// The closure equations of a chain, with lengths in units of the chain's reach and slightly perturbed axes.
template <int Size>
struct ClosureChain {
  std::vector<JointClosure<Size>> joints;
  Closure<Size> tool;  ///< quantities of loop_closure.hpp for the tool at zero readings
  double reach;        ///< reach of the chain [m]
};

/// Returns the closure equations of a chain; `reach` is their unit of length [m].
template <int Size>
ClosureChain<Size> closureChain(const AxesAtZero& axes, double reach);

/// Returns the closure equations of the chain with its k-th joint held at `reading` [rad, m].
template <int Size>
ClosureChain<Size> withJointHeld(ClosureChain<Size> chain, std::size_t k, double reading);

/// Solver of a closed chain: eliminates one or two joints next to the goal and one or two joints next to the tool, and
/// solves for the joint between them.
template <int Size>
class ClosedLoop {
 public:
  static constexpr int kJoints = Size == kLineSize ? 5 : 3;

  /// Prepares the solver; `chain` must have kJoints joints.
  explicit ClosedLoop(const ClosureChain<Size>& chain);

  /// Adds approximations of the readings that meet the goal. Complex roots with an imaginary part up to
  /// `most_imaginary` [rad] are included, because two postures may nearly coincide there on a flexible arm.
  void addRoots(const Eigen::Vector3d& p_B, const Eigen::Vector3d& axis_B, double most_imaginary,
                std::vector<Eigen::VectorXd>& roots) const;

 private:
  static constexpr int kOuter = Size == kLineSize ? 2 : 1;       ///< number of joints next to the goal
  static constexpr int kEliminated = Size == kLineSize ? 2 : 1;  ///< number of joints next to the tool
  static constexpr int kOuterTerms = Size == kLineSize ? 9 : 3, kInnerTerms = kOuterTerms;
  /// Number of equations that remain after elimination of the outer joints.
  static constexpr int kEquations = Size == kLineSize ? 6 : 2;
  static constexpr int kUnknowns = 2 * kEquations;  ///< number of unknowns of the matrix polynomial
  static_assert(kUnknowns == (Size == kLineSize ? 12 : 4));

  using Outer = Eigen::Matrix<double, Size, kOuterTerms>;
  using Inner = Eigen::Matrix<double, Size, 3 * kInnerTerms>;
  using Unknowns = Eigen::Matrix<double, kUnknowns, 1>;
  struct Sides;

  Outer outerSide(const Eigen::Vector3d& p_B, const Eigen::Vector3d& axis_B) const;
  void setInner(const Unknowns& null_vector, double x, Eigen::VectorXd& q) const;
  [[nodiscard]] Closure<Size> innerSide(const Eigen::VectorXd& q) const;
  [[nodiscard]] Eigen::VectorXd readingsAt(const Sides& sides, double x) const;

  double reach_;
  std::array<double, kJoints> zero_;
  std::array<bool, kJoints> slides_;
  std::array<JointClosure<Size>, kOuter> outer_;
  Inner inner_;  ///< terms of the tool's side, grouped by powers of the unknown x: 1, x, x^2
  Eigen::Matrix<double, 1, 3 * kInnerTerms> inner_weight_;
};

extern template ClosureChain<kLineSize> closureChain(const AxesAtZero&, double);
extern template ClosureChain<kPlaceSize> closureChain(const AxesAtZero&, double);
extern template ClosureChain<kLineSize> withJointHeld(ClosureChain<kLineSize>, std::size_t, double);
extern template ClosureChain<kPlaceSize> withJointHeld(ClosureChain<kPlaceSize>, std::size_t, double);
extern template class ClosedLoop<kLineSize>;
extern template class ClosedLoop<kPlaceSize>;

using PlaceLoop = ClosedLoop<kPlaceSize>;
using LineLoop = ClosedLoop<kLineSize>;

}  // namespace tubeplan::deflection
