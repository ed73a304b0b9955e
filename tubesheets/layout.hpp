// The drilling pattern of a tube sheet as data, and the holes that it makes.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "tubesheets/problem.hpp"
#include "tubesheets/tube.hpp"

namespace tubeplan::tubesheets {

/// A drilling pattern [m] of one of the types in layouts.hpp, which lists the numbers that each type takes.
struct Layout {
  std::string type;                                             ///< square, triangular or disc
  double pitch = std::numeric_limits<double>::quiet_NaN();      ///< distance between neighbouring centres
  double first_row = std::numeric_limits<double>::quiet_NaN();  ///< distance from the divider plate to row 1
  double radius = std::numeric_limits<double>::quiet_NaN();     ///< circle that holds all centres
  double stay_radius = 0;                                       ///< circle without centres (stay cylinder)
  int rows = 0;                                                 ///< largest number of rows; 0 = as many as fit
  int columns = 0;  ///< number of columns, centred on x = 0; 0 = as many as fit
};

/// Returns everything that keeps the layout from being drilled, or nothing. This includes a layout without holes and
/// more columns than fit, which would shift every column's number.
[[nodiscard]] std::vector<Problem> findLayoutProblems(const Layout& layout);

/// Returns the holes row by row, all open, in the hot leg's or the full sheet's frame. The layout must have no
/// problems.
[[nodiscard]] std::vector<Tube> makeTubes(const Layout& layout);

}  // namespace tubeplan::tubesheets
