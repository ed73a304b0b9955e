// Drawing of an arm in side view and top view, as SVG.
#pragma once

#include <string>

#include "app/formats/units.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

/// Returns an SVG drawing of the arm with each joint at the middle of its limits (at zero without limits). Links are
/// lines, revolute joints circles, and prismatic joints squares. The deflected shape has a second colour, and there is
/// a scale bar.
[[nodiscard]] std::string armDrawing(const deflection::Arm& arm, const Units& units);

}  // namespace tubeplan::app
