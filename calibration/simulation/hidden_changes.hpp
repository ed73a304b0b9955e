// Table of changes that simulations of an outage hide in the true arm or its base, each with the cause that a watch
// should name.
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <span>
#include <string>

#include "deflection/arm.hpp"

namespace tubeplan::calibration {

/// True arm, and pose of its base in the world.
struct TrueState {
  deflection::Arm arm;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
};

/// Returns the state of arm and base at the `n`-th visit since the change, counted from 1.
using ChangedState = std::function<TrueState(int n)>;

/// Returns a random unit vector in the world frame.
using DrawDirection = std::function<Eigen::Vector3d()>;

/// A change that is hidden in an outage: one row of the table.
struct HiddenChange {
  const char *name, *words;
  const char* effect;  ///< name of the cause that a watch should find; empty for the row without a change
  /// Returns the place of the cause as the watch writes it; empty if the arm has no place for this change.
  std::string (*at)(const deflection::Arm& arm);
  bool is_ramp;  ///< true if the change grows from visit to visit
  ChangedState (*make)(const TrueState& before, const DrawDirection& draw);
};

/// Returns the table of hidden changes; the first row is the outage without a change.
[[nodiscard]] std::span<const HiddenChange> hiddenChanges();

/// Returns a state that does not change.
[[nodiscard]] ChangedState constantState(TrueState state);

/// Returns the state with the offset of a row's joint increased by `angle` [rad].
[[nodiscard]] TrueState withOffset(TrueState state, int row, double angle);

/// Returns the row of the last revolute joint but one, or of the only one; -1 if there is none.
[[nodiscard]] int slippingRow(const deflection::Arm& arm);

}  // namespace tubeplan::calibration
