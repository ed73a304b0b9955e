// Writer of an arm's parameters into the URDF file from which the arm was imported, with everything else unchanged.
#pragma once

#include <string>
#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::app {

struct UrdfEdit {
  std::string text;
  std::vector<std::string> changed;   ///< changes of joints, one sentence each; empty if the text is unchanged
  std::vector<std::string> left_out;  ///< data of the arm that URDF text cannot express, one sentence each
};

/// Returns the URDF text with the arm's origins and limits, and with every other byte unchanged. The offset of a joint
/// rotates or shifts the joint's origin about or along the joint's axis; links keep their frames, shapes and masses.
/// The tool's tip becomes the origin of the tip link's fixed joint; if the tip link has none, a link and a joint `tip`
/// are added. Throws InputError unless the arm has the same rows as the result of parseUrdf() for `text` and `tip`.
[[nodiscard]] UrdfEdit withArmInUrdf(const std::string& text, const std::string& file, const std::string& tip,
                                     const deflection::Arm& arm);

}  // namespace tubeplan::app
