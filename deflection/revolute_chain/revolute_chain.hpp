// An arm's chain as a sequence of rotations about one axis each, which is the form that the kernels solve. Not every
// arm can be converted to it.
#pragma once

#include <optional>
#include <vector>

#include "deflection/chain.hpp"
#include "deflection/equilibrium.hpp"
#include "deflection/revolute_chain/revolute_arm.hpp"

namespace tubeplan::deflection::simd {

/// An element of the chain: its turn, its axis and its compliance.
struct RevoluteElement {
  int turn;              ///< index of the element's turn; -1 if the element is rigid
  Eigen::Vector3d axis;  ///< unit length, in the element's near axes
  double compliance;     ///< compliance about the axis [rad/(N m)]
  bool is_beam;
  Eigen::Vector3d member;  ///< member of a beam, in its near axes [m]
};

/// A direction in the frame of a turn.
struct TurnDirection {
  int turn = -1;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
};

/// A row's frame, fixed to a turn or, if `turn` is -1, to the base.
struct RowOnTurn {
  int row = -1, turn = -1;
  PoseOf<double> X_TL;
};

class RevoluteChain {
 public:
  /// Builds the chain. `joint_of` holds the index of the reading that rotates each link of the chain, -1 for none;
  /// `elements` are the elements of the chain, in order. Returns std::nullopt if an element is compliant about more
  /// than one axis or has a clearance or a soft zone, or if the arm is too long.
  static std::optional<RevoluteChain> of(const Chain<double>& chain, const Arm& arm, const std::vector<int>& joint_of,
                                         const std::vector<FlexibleElement>& elements, double reach);

  [[nodiscard]] RevoluteArm numbers() const;
  [[nodiscard]] const std::vector<RevoluteElement>& elements() const { return elements_; }
  [[nodiscard]] bool hasJacobian() const { return has_jacobian_; }
  /// Returns the z axis of the last row that has a joint.
  [[nodiscard]] const TurnDirection& lastAxis() const { return last_axis_; }
  /// Returns every row's frame, in order; empty if a row lies between two components that were merged into one turn.
  [[nodiscard]] const std::vector<RowOnTurn>& rows() const { return rows_; }

  /// Sets the deflections of the elements from a kernel's output for each turn (Shapes::element_states, with values
  /// `stride` apart).
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
