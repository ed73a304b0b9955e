// The way along an arm from axis to axis, as short as it can be: what its size is by, however its rows are written.
#pragma once

#include <vector>

#include "deflection/scalar.hpp"

namespace tubeplan::deflection {

/// A point of a line [m] and the line's direction, of length one; both ends of a chain are points alone.
struct ChainLine {
  Eigen::Vector3d point, direction = Eigen::Vector3d::UnitZ();
  bool may_slide = true;  ///< whether any other point of the line would do as well
};

/// Slides points along their lines to where the chain from the first to the last of them is nearly as short as it can
/// be, and returns how far [m]. Where the chain then leads depends on the lines alone, if all but its ends may slide.
///
/// Each step makes the sum of squares least with each piece weighted by its length before (Weiszfeld 1937), so the sum
/// of lengths never grows. The first step starts from the least sum of squares, which no point given enters.
std::vector<double> shortenChain(std::vector<ChainLine>& chain);

/// The same of a chain that is more than twice as long as it would be then; any other stays as it is.
std::vector<double> drawTogether(std::vector<ChainLine>& chain);

/// From point to point [m].
[[nodiscard]] double chainLength(const std::vector<ChainLine>& chain);

}  // namespace tubeplan::deflection
