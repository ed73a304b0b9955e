// Effects that act alike at every posture, written as numbers of the arm: offsets of joints, and errors of links and
// tool. Files without effects, such as URDF, can then state them.
#pragma once

#include <string>
#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::deflection {

struct ArmByNumbers {
  Arm arm;                           ///< arm with the same poses; its effects are those that depend on the posture
  std::vector<std::string> written;  ///< names of the effects that became numbers, such as "tool-offset@tool"
};

/// Returns the arm with every effect that is a constant change of geometry or of a joint's reading written into the
/// numbers of its rows and tool.
[[nodiscard]] ArmByNumbers writeConstantEffects(const Arm& arm);

}  // namespace tubeplan::deflection
