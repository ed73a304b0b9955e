// An arm drawn from the side and from above, as SVG.
#pragma once

#include <string>

#include "app/formats/units.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

/// All joints in the middle of their limits (at zero where they have none): links as lines, joints as circles (squares
/// where they slide), the deflected shape in a second colour, a scale beside it.
[[nodiscard]] std::string armDrawing(const deflection::Arm& arm, const Units& units);

}  // namespace tubeplan::app
