// Writer of an arm's numbers into the URDF file from which it was imported, with everything else unchanged.
#pragma once

#include <string>
#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::app {

struct UrdfEdit {
  std::string text;
  std::vector<std::string> changed;   ///< changes of joints, a sentence each; empty if the text is unchanged
  std::vector<std::string> left_out;  ///< data of the arm that the text lacks, a sentence each
};

/// Returns the text with the arm's origins and limits and every other byte unchanged. The arm must have the rows of
/// `parseUrdf` for the text and `tip`. An offset of a joint rotates, or shifts, its origin about the joint's axis;
/// links keep their frames, shapes and masses. The tool's tip is the origin of the fixed joint of the tip link; without
/// one, a link and a joint `tip` are added. Throws InputError if the rows differ.
[[nodiscard]] UrdfEdit withArmInUrdf(const std::string& text, const std::string& file, const std::string& tip,
                                     const deflection::Arm& arm);

}  // namespace tubeplan::app
