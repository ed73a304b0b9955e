// Equivalent form of an arm in which the row origins lie close to each other.
//
// A row's origin may lie anywhere on the row's axis. Denavit-Hartenberg parameters put it on the common normal of two
// axes. On a calibrated arm with nearly parallel axes, that normal can be hundreds of metres away; the large d
// parameters of adjacent rows then cancel each other. Member lengths must not be computed from such rows.
#pragma once

#include <string>
#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::deflection {

struct AnchoredRows {
  /// Arm with the frames of some rows moved along their z axes: tip, joint axes and loads are unchanged. If any row is
  /// moved, the arm has no effects, because effects refer to the rows as they were written.
  Arm arm;
  std::vector<double> slid;  ///< shift of each row's frame along its own z axis [m]
};

/// Returns the arm with its row origins moved closer together. Rows for which heldAgainstSlide() states a reason keep
/// their origin. An arm whose path from origin to origin is no more than twice as long as the shortest path is returned
/// unchanged.
[[nodiscard]] AnchoredRows anchoredRows(const Arm& arm);

/// Returns the reason why a row's origin must not be moved along its z axis, in words that follow the row's name; empty
/// if it may be moved.
[[nodiscard]] std::string heldAgainstSlide(const Arm& arm, std::size_t row);

}  // namespace tubeplan::deflection
