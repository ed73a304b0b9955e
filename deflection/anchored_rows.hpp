// An arm whose rows' origins lie near each other, whatever rows it is written with.
//
// A row's origin may stand anywhere on its axis. Denavit-Hartenberg numbers put it where the common normal of two axes
// is; of axes that are nearly parallel, as those of a calibrated arm, that is hundreds of metres away, and the d of one
// row undoes that of another. Nothing that asks how long an arm's members are may see that.
#pragma once

#include <string>
#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::deflection {

struct AnchoredRows {
  /// The same arm, some rows' frames slid along their z axes: tip, axes and what hangs where are as before. Where any
  /// is slid, it is without its effects, which speak of the rows as they were written.
  Arm arm;
  std::vector<double> slid;  ///< m, by rows; a point of the row's frame has a z that is less by this
};

/// Rows that heldAgainstSlide() has a reason for stay where they are. An arm whose way from origin to origin is no more
/// than twice the shortest is left as it is.
[[nodiscard]] AnchoredRows anchoredRows(const Arm& arm);

/// Why a row's origin may not slide along its z, in words that go after its name; empty where it may.
[[nodiscard]] std::string heldAgainstSlide(const Arm& arm, std::size_t row);

}  // namespace tubeplan::deflection
