// Selection of the geometric parameters of an arm that a fit can free together: as many as move the tool independently
// of one another.
#pragma once

#include <string>
#include <vector>

#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Returns true if the named parameter is geometric: a row's placement, a joint's zero, the tool's tip or its rotation.
[[nodiscard]] bool isGeometry(const std::string& name);

/// Returns true if the named parameter shifts the first axis along its own y, as a free base can do too.
[[nodiscard]] bool isShiftOfFirstAxis(const std::string& name);

/// Member of a set of independent geometric parameters.
struct IndependentNumber {
  std::string name;
  /// Standard deviation of this parameter caused by the errors of the parameters that it replaces.
  double others_sigma = 0;
};

/// Returns a set of geometric parameters that is complete and not redundant, given the unknowns that are already free:
/// every motion of the tool that geometry can cause results from exactly one combination of the set and those unknowns.
/// The set has four parameters per revolute row, two per prismatic row and six for the tool, less six if no base is
/// known (Everett 1987). This holds in whatever convention the rows are written. If no reading depends on the tool's
/// rotation (`placed.shows_tool_turn` is false), the set has three fewer: rotations of the tool about its tip then
/// count as already free, and the last joint's zero replaces one coordinate of the tip.
///
/// Joint zeros are tried first, then the tip, then rows that move, then other rows. The first row's b is tried last,
/// because it adds a motion only if the base is known. Among equally independent parameters, the first in file order is
/// taken. A parameter that earlier ones nearly replace is deferred until all others have been tried. For nearly
/// parallel axes, therefore, beta is taken and d is not (Hayati and Mirmirani 1985), and the last joint's zero is not
/// taken if the tip is near the joint's axis. Parameters that are not taken may deviate from the drawing too, by the
/// standard deviations in `placed.priors`; the parameters taken absorb these deviations in addition to their own.
[[nodiscard]] std::vector<IndependentNumber> independentGeometry(const PlacedArm& placed,
                                                                 const std::vector<Unknown>& free);

}  // namespace tubeplan::calibration
