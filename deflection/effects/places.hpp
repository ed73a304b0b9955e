// The places of an arm, by the rules that effects have for them.
#pragma once

#include "deflection/effects/effect.hpp"

namespace tubeplan::deflection::places {

std::vector<Place> ofJoints(const Arm& arm);
std::vector<Place> ofRevoluteJoints(const Arm& arm);

/// Every ordered pair of two joints of the same type: `row` takes from `other`.
std::vector<Place> ofJointPairs(const Arm& arm);

/// Every slide with every revolute joint: `row` takes from `other`.
std::vector<Place> ofSlidesTurned(const Arm& arm);

std::vector<Place> ofRows(const Arm& arm);

/// The rows, or rows and axes, that a rule accepts.
std::vector<Place> ofRows(const Arm& arm, bool (*accepts)(const Arm&, int row));
std::vector<Place> ofAxes(const Arm& arm, bool (*accepts)(const Arm&, int row, int axis));

/// The one place of a fixed word.
std::vector<Place> theOnly(const Arm& arm);

}  // namespace tubeplan::deflection::places
