// Separate error of each point (or posture, if measurements name no point): more variance between points than within
// them.
//
// Basis: one parameter per point.
#pragma once

#include "calibration/estimation/held_out.hpp"
#include "calibration/patterns/pattern.hpp"

namespace tubeplan::calibration::patterns::point {

inline std::vector<Variable> variables(const MeasurementScene& scene) {
  const std::vector<int> pose = groupByPose(scene.measurements);
  std::vector<std::string> names(pose.size());
  for (std::size_t k = 0; k < pose.size(); ++k)
    names[k] =
        scene.measurements[k].point.empty() ? "posture " + std::to_string(pose[k] + 1) : scene.measurements[k].point;
  const Variable variable = groupVariable("point", names);
  if (variable.groups.size() < 2 || variable.groups.size() == names.size()) return {};
  return {variable};
}

inline PatternKind kind() {
  return {.name = "point", .needs = "two points or more, some read more than once", .variables = variables};
}

}  // namespace tubeplan::calibration::patterns::point
