// Drawing of an arm in side view and top view, as SVG.
#pragma once

#include <string>

#include "app/formats/units.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

/// Returns an SVG drawing of the arm with each joint at the middle of its limits, or at zero if it has none. Links are
/// drawn as lines, revolute joints as circles, prismatic joints as squares, the deflected shape in a second colour. A
/// scale bar shows the length unit.
[[nodiscard]] std::string armDrawing(const deflection::Arm& arm, const Units& units);

}  // namespace tubeplan::app
