// An arm's chain as rotations about one axis each, for arms that are such: the form that the kernels solve fast.
#pragma once

#include <optional>
#include <vector>

#include "deflection/chain.hpp"
#include "deflection/equilibrium.hpp"
#include "deflection/revolute_chain/revolute_arm.hpp"

namespace tubeplan::deflection::simd {

/// Role of an element in the chain.
struct RevoluteElement {
  int turn;              ///< turn of the arm that it is, or is part of; -1 if it is rigid
  Eigen::Vector3d axis;  ///< unit length, in the element's near axes
  double compliance;     ///< about the axis [rad/(N m)]
  bool is_beam;
  Eigen::Vector3d member;  ///< vector of a beam, in its near axes [m]
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
  /// Builds the chain. `joint_of` holds the reading that turns each link of the chain, -1 for none; `elements` are the
  /// chain's, in order. Nothing if an element is compliant about more than one axis, has a clearance or a soft zone, or
  /// if the arm is too long.
  static std::optional<RevoluteChain> of(const Chain<double>& chain, const Arm& arm, const std::vector<int>& joint_of,
                                         const std::vector<FlexibleElement>& elements, double reach);

  [[nodiscard]] RevoluteArm numbers() const;
  [[nodiscard]] const std::vector<RevoluteElement>& elements() const { return elements_; }
  [[nodiscard]] bool hasJacobian() const { return has_jacobian_; }
  /// Returns the z axis of the last jointed row's frame.
  [[nodiscard]] const TurnDirection& lastAxis() const { return last_axis_; }
  /// Returns every row's frame, in order; empty if one of them lies between two parts of the same turn.
  [[nodiscard]] const std::vector<RowOnTurn>& rows() const { return rows_; }

  /// Sets the deflections of the elements from a kernel's output for each turn (Shapes::element_states, `stride`
  /// apart).
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
