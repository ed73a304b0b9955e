// All readings of a rigid chain that meet a goal, found together: the roots of its closure by the eigenvalues of a
// matrix polynomial (Manocha and Canny 1994, "Efficient inverse kinematics for general 6R manipulators", IEEE Trans.
// Robot. Automat. 10). Three joints hold a place: at most four postures. Five hold a place and an axis, with the roll
// about it free: at most sixteen. Slides are joints as others are.
//
// The roots are those of a chain whose axes are moved by a ten-thousandth. So no design is a special case of the
// equations: parallel or intersecting axes, which would make matrices singular, only make them nearly singular.
// Iterations lead from the roots to the postures of the chain itself. Internal to the inverse.
#pragma once

#include <vector>

#include "deflection/inverse/loop_closure.hpp"

namespace tubeplan::deflection {

/// The closure of a chain in units of its reach, with its axes perturbed slightly.
template <int Size>
struct ClosureChain {
  std::vector<JointClosure<Size>> joints;
  Closure<Size> tool;  ///< tool at zero readings
  double reach;        ///< [m]
};

/// Returns the closure of a chain; `reach` is the unit of length of the equations [m].
template <int Size>
ClosureChain<Size> closureChain(const AxesAtZero& axes, double reach);

/// Returns the chain without its k-th joint, which is held at a reading.
template <int Size>
ClosureChain<Size> withJointHeld(ClosureChain<Size> chain, std::size_t k, double reading);

/// Solver of a closed chain: one or two joints beside the goal and one or two beside the tool are eliminated, one
/// between is solved for.
template <int Size>
class ClosedLoop {
 public:
  static constexpr int kJoints = Size == kLineSize ? 5 : 3;

  /// `chain` must have kJoints joints.
  explicit ClosedLoop(const ClosureChain<Size>& chain);

  /// Adds readings near those that meet the goal. Complex roots with an imaginary part up to `most_imaginary` [rad]
  /// count too, because two postures are about to coincide there, or would on a flexible arm.
  void addRoots(const Eigen::Vector3d& p_B, const Eigen::Vector3d& axis_B, double most_imaginary,
                std::vector<Eigen::VectorXd>& roots) const;

 private:
  static constexpr int kOuter = Size == kLineSize ? 2 : 1;       ///< joints beside the goal
  static constexpr int kEliminated = Size == kLineSize ? 2 : 1;  ///< joints beside the tool
  static constexpr int kOuterTerms = Size == kLineSize ? 9 : 3, kInnerTerms = kOuterTerms;
  /// Equations left after elimination of the outer joints.
  static constexpr int kEquations = Size == kLineSize ? 6 : 2;
  static constexpr int kUnknowns = 2 * kEquations;  ///< unknowns of the matrix polynomial
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
  Inner inner_;  ///< terms of the tool's side, those of x^2 first
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
