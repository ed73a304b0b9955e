// Lists of the locations in an arm where effects can act.
#pragma once

#include "deflection/effects/effect.hpp"

namespace tubeplan::deflection::places {

std::vector<Place> ofJoints(const Arm& arm);
std::vector<Place> ofRevoluteJoints(const Arm& arm);

/// Returns every ordered pair of two joints of the same type: joint `row` is driven by joint `other`.
std::vector<Place> ofJointPairs(const Arm& arm);

/// Returns every pair of a prismatic and a revolute joint: the prismatic joint `row` is driven by the revolute joint
/// `other`.
std::vector<Place> ofSlidesTurned(const Arm& arm);

std::vector<Place> ofRows(const Arm& arm);

/// Return the rows, or rows and axes, for which `accepts` returns true.
std::vector<Place> ofRows(const Arm& arm, bool (*accepts)(const Arm&, int row));
std::vector<Place> ofAxes(const Arm& arm, bool (*accepts)(const Arm&, int row, int axis));

/// Returns the only place of an effect whose kind has PlaceRule::kWord.
std::vector<Place> singlePlace(const Arm& arm);

}  // namespace tubeplan::deflection::places
