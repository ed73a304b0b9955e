// Drawing of an arm from the side and from above, as SVG.
#pragma once

#include <string>

#include "app/formats/units.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

/// Draws all joints at the middle of their limits (at zero if they have none): links as lines, joints as circles
/// (squares if they slide), the deflected shape in a second colour, with a scale.
[[nodiscard]] std::string armDrawing(const deflection::Arm& arm, const Units& units);

}  // namespace tubeplan::app
