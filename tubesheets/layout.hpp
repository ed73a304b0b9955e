// The drilling pattern of a tube sheet as data, and the holes that it makes.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "tubesheets/problem.hpp"
#include "tubesheets/tube.hpp"

namespace tubeplan::tubesheets {

/// A pattern of one of the types in layouts.hpp, which says which of these numbers it takes. [m]
struct Layout {
  std::string type;                                             ///< square, triangular, disc
  double pitch = std::numeric_limits<double>::quiet_NaN();      ///< between neighbouring centres
  double first_row = std::numeric_limits<double>::quiet_NaN();  ///< from the divider plate to row 1
  double radius = std::numeric_limits<double>::quiet_NaN();     ///< no centre lies outside
  double stay_radius = 0;                                       ///< no centre lies inside (stay cylinder)
  int rows = 0;                                                 ///< at most; 0 = as many as fit
  int columns = 0;                                              ///< numbered and centred on x = 0; 0 = as many as fit
};

/// Everything that keeps the layout from being drilled; empty when it can be. Also finds a layout without holes and
/// more columns than fit, for these would shift every column's number.
[[nodiscard]] std::vector<Problem> findLayoutProblems(const Layout& layout);

/// The holes, row by row, all open, in the hot leg's or the full sheet's frame. The layout must have no problems.
[[nodiscard]] std::vector<Tube> makeTubes(const Layout& layout);

}  // namespace tubeplan::tubesheets
