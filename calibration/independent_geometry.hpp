// Choice of an arm's geometric numbers that a fit can free together: as many as move the tool independently of each
// other.
#pragma once

#include <string>
#include <vector>

#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Returns true if a parameter of that name is geometric: a row's placement, a joint's zero, the tool's tip and
/// rotation.
[[nodiscard]] bool isGeometry(const std::string& name);

/// Returns whether a parameter of that name shifts the first axis along its own y, as a free base does.
[[nodiscard]] bool isShiftOfFirstAxis(const std::string& name);

/// A number of such a set.
struct IndependentNumber {
  std::string name;
  /// Standard deviation of this number by the errors of the numbers that it replaces.
  double others_sigma = 0;
};

/// Returns a set of geometry that is complete and not redundant beside the unknowns that are free already:
/// every motion of the tool that geometry can make is made by one combination of these, those unknowns and no other.
/// The set has four numbers for a row that turns, two for a slide and six of the tool, less six where no base is known
/// (Everett 1987); however the rows are written, and whatever readings there are. Where the tool's turn reaches no
/// reading (`placed.shows_tool_turn`), three fewer: what only turns the tool about its tip counts as free already, and a
/// last joint's zero stands for one number of the tip.
///
/// Joint zeros come first, then the tip, then rows that move, then others, and last the first row's b, which only
/// beside a known base says anything new. Of equals the first in file order is taken; a number that the ones before
/// nearly replace waits for what they do not, so that of nearly parallel axes beta is taken and d is not (Hayati and
/// Mirmirani 1985), and the last joint's zero is not where the tip is near its axis. What is not taken may be off its drawing all the same, by `placed.priors`: the numbers taken have
/// its part besides their own.
[[nodiscard]] std::vector<IndependentNumber> independentGeometry(const PlacedArm& placed,
                                                                 const std::vector<Unknown>& free);

}  // namespace tubeplan::calibration
