// Selection of geometric parameters of an arm that a fit can free together: each moves the tool in a way that no
// combination of the others can.
#pragma once

#include <string>
#include <vector>

#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Returns true if the named parameter is geometric: a row's placement, a joint's zero, the tool's tip or its rotation.
[[nodiscard]] bool isGeometry(const std::string& name);

/// Returns true if the named parameter shifts the first joint axis along its own y axis; a free base has the same
/// effect.
[[nodiscard]] bool isShiftOfFirstAxis(const std::string& name);

/// One of the geometric parameters that independentGeometry() selects.
struct IndependentNumber {
  std::string name;
  /// Standard deviation added to this parameter's own, because it also absorbs the errors of parameters that stay
  /// fixed.
  double others_sigma = 0;
};

/// Returns a minimal set of geometric parameters that, together with the unknowns already in `free`, can reproduce
/// every change of the tool pose that any geometric parameter causes. The set has four parameters per revolute row, two
/// per prismatic row and six for the tool, less six if no base is known (Everett 1987), in any kinematic convention of
/// the rows. If no measurement depends on the tool's rotation (`placed.shows_tool_turn` is false), the set has three
/// parameters fewer: rotations of the tool about its tip are then treated as already free, and the last joint's zero
/// replaces one coordinate of the tip.
///
/// Joint zeros are tried first, then the tip, then rows with a moving joint, then other rows. The first row's b is
/// tried last, because it adds a motion only if the base is known. Among equally independent parameters, the first in
/// file order is taken. A parameter whose effect is nearly a combination of those already taken is deferred until all
/// others have been tried. For nearly parallel axes, therefore, beta is taken and d is not (Hayati and Mirmirani 1985),
/// and the last joint's zero is not taken if the tip is near the joint's axis. Parameters that are not taken may also
/// deviate from the drawing, with the standard deviations in `placed.priors`; the parameters taken absorb these
/// deviations in addition to their own.
[[nodiscard]] std::vector<IndependentNumber> independentGeometry(const PlacedArm& placed,
                                                                 const std::vector<Unknown>& free);

}  // namespace tubeplan::calibration
