// The places of an arm, by the rules that effects have for them.
#pragma once

#include "deflection/effects/effect.hpp"

namespace tubeplan::deflection::places {

std::vector<Place> ofJoints(const Arm& arm);
std::vector<Place> ofRevoluteJoints(const Arm& arm);

/// Returns every ordered pair of two joints of the same type: `row` is driven by `other`.
std::vector<Place> ofJointPairs(const Arm& arm);

/// Returns every pair of a slide and a revolute joint: `row` is driven by `other`.
std::vector<Place> ofSlidesTurned(const Arm& arm);

std::vector<Place> ofRows(const Arm& arm);

/// Return the rows, or rows and axes, that a rule accepts.
std::vector<Place> ofRows(const Arm& arm, bool (*accepts)(const Arm&, int row));
std::vector<Place> ofAxes(const Arm& arm, bool (*accepts)(const Arm&, int row, int axis));

/// Returns the one place of a fixed word.
std::vector<Place> theOnly(const Arm& arm);

}  // namespace tubeplan::deflection::places
