// Derivatives of an arm's links, elements and loads with respect to a few variables, converted into motion of the tip
// by the sensitivities of the solved shape.
//
// The derivatives are computed row by row, with dual numbers in the templates that build the chain and its elements.
// Links are not built for rows that do not depend on the variables.
#pragma once

#include <vector>

#include "deflection/tip_sensitivity.hpp"

namespace tubeplan::deflection {

/// Tip motion (translation [m], then rotation vector [rad]); one column for each derivative of a dual number.
using TipColumns = Eigen::Matrix<double, 6, kDualSize>;

bool changes(const Dual& x);
bool changes(const Vector3<Dual>& v);

/// Adds the motion of a tip that is fixed in the moving frame `frame`. `p` is the vector from the frame's origin to the
/// tip [m]. Both are given in the same axes A.
void addMotion(const PoseOf<Dual>& frame, const Eigen::Vector3d& p, TipColumns& tip);

/// Adds the rotation of the tool frame caused by a change of `turn_L`; `R_BL` are the last row's axes at the tip.
void addToolTurn(const Vector3<Dual>& turn_L, const Eigen::Matrix3d& R_BL, TipColumns& tip);

class DirectChanges {
 public:
  /// Uses the shape last solved by `arm`, about which `sensitivity` was linearised. Both must outlive this object. Call
  /// begin() again after either has processed another shape.
  DirectChanges(const PreparedArm& arm, const TipSensitivity& sensitivity) : arm_(arm), sensitivity_(sensitivity) {}

  void begin();

  /// Adds the motion of the tip caused by changes of a row, of the row's reading (joint offset included) and of the
  /// vector to the next row.
  void addRow(std::size_t index, const Row<Dual>& row, const Dual& reading, const Vector3<Dual>& to_next,
              TipColumns& tip);

  /// Adds the motion of the tip caused by changes of a row's flexible elements alone.
  void addElements(std::size_t index, const Row<Dual>& row, TipColumns& tip);

  /// Adds the motion of the tip caused by a change of a row's reading alone.
  void addTurn(std::size_t index, const Dual& reading, TipColumns& tip) const;

  void addGravity(const Vector3<Dual>& gravity_B, TipColumns& tip) const;
  void addTipLoad(const Dual& load, const std::optional<TipLoad<Dual>>& added, TipColumns& tip) const;

 private:
  void addLink(std::size_t k, const ChainLink<Dual>& link, TipColumns& tip) const;
  void addElement(std::size_t e, const ChainLink<Dual>& link, const Row<Dual>& row, TipColumns& tip) const;

  const PreparedArm& arm_;
  const TipSensitivity& sensitivity_;
  std::vector<std::size_t> first_link_, first_element_;  ///< first link and first element of each row
  Chain<Dual> chain_;
};

}  // namespace tubeplan::deflection
