// Units of the input files and of Calkins 1994, expressed in internal units.
#pragma once

#include <numbers>

namespace tubeplan {

inline constexpr double kInch = 0.0254;            // [m]
inline constexpr double kPound = 4.4482216152605;  // [N]
inline constexpr double kDegree = std::numbers::pi / 180;

}  // namespace tubeplan
