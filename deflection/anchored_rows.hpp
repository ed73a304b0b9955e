// An arm with row origins near each other, however its rows are written.
//
// A row's origin may stand anywhere on its axis. Denavit-Hartenberg numbers put it where the common normal of two axes
// is; of axes that are nearly parallel, as those of a calibrated arm, that is hundreds of metres away, and the d of one
// row undoes that of another. Lengths of members must not be computed from such rows.
#pragma once

#include <string>
#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::deflection {

struct AnchoredRows {
  /// Arm with some rows' frames moved along their z axes: tip, joint axes and loads are unchanged. If any row is moved,
  /// it has no effects, because these refer to the rows as they were written.
  Arm arm;
  std::vector<double> slid;  ///< shift of each row's frame along z [m]; the z of a point in it is less by this
};

/// Returns the arm with its rows' origins moved together. Rows with a reason in heldAgainstSlide() keep theirs. An arm
/// whose path from origin to origin is no more than twice the shortest is returned unchanged.
[[nodiscard]] AnchoredRows anchoredRows(const Arm& arm);

/// Returns why a row's origin must not be moved along its z, in words that follow its name; empty if it may be moved.
[[nodiscard]] std::string heldAgainstSlide(const Arm& arm, std::size_t row);

}  // namespace tubeplan::deflection
