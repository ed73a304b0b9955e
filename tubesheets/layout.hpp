// The drilling pattern of a tube sheet as data, and the generation of its holes.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "tubesheets/problem.hpp"
#include "tubesheets/tube.hpp"

namespace tubeplan::tubesheets {

/// A drilling pattern [m] of one of the types in layouts.hpp, which lists the values that each type requires.
struct Layout {
  std::string type;                                         ///< square, triangular or disc
  double pitch = std::numeric_limits<double>::quiet_NaN();  ///< distance between the centres of neighbouring holes
  /// Distance from the divider plate to the centres of row 1.
  double first_row = std::numeric_limits<double>::quiet_NaN();
  double radius = std::numeric_limits<double>::quiet_NaN();  ///< radius of the circle that contains all hole centres
  double stay_radius = 0;  ///< radius of the central circle without hole centres (stay cylinder)
  int rows = 0;            ///< largest number of rows; 0 means as many as fit
  int columns = 0;         ///< number of columns, centred on x = 0; 0 means as many as fit
};

/// Returns the problems that prevent makeTubes(); empty if there are none. More columns than fit are a problem, because
/// every column number would be shifted.
[[nodiscard]] std::vector<Problem> findLayoutProblems(const Layout& layout);

/// Returns the holes row by row, all open, in the frame of the hot leg or of the full sheet. The layout must have no
/// problems.
[[nodiscard]] std::vector<Tube> makeTubes(const Layout& layout);

}  // namespace tubeplan::tubesheets
