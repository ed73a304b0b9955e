// The numbers of an arm put into the URDF file that it was imported from, all else of the file left as it is.
#pragma once

#include <string>
#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::app {

struct UrdfEdit {
  std::string text;
  std::vector<std::string> changed;   ///< joints and what of them, a sentence each; none: the text is the given one
  std::vector<std::string> left_out;  ///< what of the arm the text has not, a sentence each
};

/// The text with the origins and limits that the arm has otherwise, and not a byte else: the arm's rows are those that
/// `parseUrdf` makes of the text and `tip`. An offset of a joint turns, or shifts, its origin about the joint's axis;
/// links keep their frames, and what is drawn and weighed in them. The tool's tip is the origin of the fixed joint that
/// carries the tip link; without one, a link and a joint `tip` are added. Throws InputError where the rows differ.
[[nodiscard]] UrdfEdit withArmInUrdf(const std::string& text, const std::string& file, const std::string& tip,
                                     const deflection::Arm& arm);

}  // namespace tubeplan::app
