// Lists of measurement ids and units of joints, for the messages of checks.
#pragma once

#include <string>
#include <vector>

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration {

/// Returns a list such as "a, b, c, d, e and 3 more", with at most five ids in full.
[[nodiscard]] inline std::string listOf(const std::vector<std::string>& ids) {
  constexpr std::size_t kMostListed = 5;
  std::string text;
  for (std::size_t k = 0; k < ids.size() && k < kMostListed; ++k) text += (k ? ", " : "") + ids[k];
  return ids.size() > kMostListed ? text + " and " + std::to_string(ids.size() - kMostListed) + " more" : text;
}

/// Returns the value of `--assume` that excludes the measurements with these ids; empty if there are too many for one
/// line.
[[nodiscard]] inline std::string assumeWithout(const std::vector<std::string>& ids) {
  constexpr std::size_t kMostAssumed = 20;
  if (ids.size() > kMostAssumed) return "";
  std::string text;
  for (const auto& id : ids) text += (text.empty() ? "without=" : ",without=") + id;
  return text;
}

/// Returns the unit of a joint's column; the common unit of angles or coordinates if no unit is known for the column.
[[nodiscard]] inline NamedUnit columnUnitOf(const CheckedMeasurements& checked, int joint) {
  const auto& units = checked.units;
  if (static_cast<std::size_t>(joint) < units.joints.size()) return units.joints[static_cast<std::size_t>(joint)];
  return checked.start.arm.joint(joint).type == deflection::JointType::kRevolute ? units.angles : units.coordinates;
}

}  // namespace tubeplan::calibration
