// An arm's chain as turns about one axis each, where that is what it is: what the kernels solve fast.
#pragma once

#include <optional>
#include <vector>

#include "deflection/chain.hpp"
#include "deflection/equilibrium.hpp"
#include "deflection/revolute_chain/revolute_arm.hpp"

namespace tubeplan::deflection::simd {

/// How an element of the chain takes part.
struct RevoluteElement {
  int turn;              ///< which of the arm's turns it is, or is part of; -1 where it gives nothing
  Eigen::Vector3d axis;  ///< unit length, in the element's near axes
  double compliance;     ///< about it [rad/(N m)]
  bool is_beam;
  Eigen::Vector3d member;  ///< of a beam, in its near axes [m]
};

/// A direction fixed to a turn.
struct TurnDirection {
  int turn = -1;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
};

/// A row's frame, fixed to a turn (-1: to the base).
struct RowOnTurn {
  int row = -1, turn = -1;
  PoseOf<double> X_TL;
};

class RevoluteChain {
 public:
  /// `joint_of` says which reading turns a link of the chain, -1 for none; `elements` are the chain's, in order.
  /// Nothing where an element gives about more than one axis, has a clearance or a soft zone, or where the arm is too
  /// long.
  static std::optional<RevoluteChain> of(const Chain<double>& chain, const Arm& arm, const std::vector<int>& joint_of,
                                         const std::vector<FlexibleElement>& elements, double reach);

  [[nodiscard]] RevoluteArm numbers() const;
  [[nodiscard]] const std::vector<RevoluteElement>& elements() const { return elements_; }
  [[nodiscard]] bool hasJacobian() const { return has_jacobian_; }
  /// The z axis of the last jointed row's frame.
  [[nodiscard]] const TurnDirection& lastAxis() const { return last_axis_; }
  /// Every row's frame, in order; empty where one of them lies between two things that turn as one.
  [[nodiscard]] const std::vector<RowOnTurn>& rows() const { return rows_; }

  /// Gives the elements their deflections, from what a kernel says of each turn (Shapes::gives, `stride` apart).
  void copyDeflections(const double* element_states, long stride, std::vector<FlexibleElement>& elements) const;

 private:
  class Builder;

  std::vector<Turn> turns_;
  RevoluteArm numbers_{};
  std::vector<RevoluteElement> elements_;
  TurnDirection last_axis_;
  std::vector<RowOnTurn> rows_;
  bool has_jacobian_ = false;
};

}  // namespace tubeplan::deflection::simd
