// The shortest path along an arm from axis to axis: a measure of its size, however its rows are written.
#pragma once

#include <vector>

#include "deflection/scalar.hpp"

namespace tubeplan::deflection {

/// A point of a line [m] and the line's direction, of length one; both ends of a chain are points alone.
struct ChainLine {
  Eigen::Vector3d point, direction = Eigen::Vector3d::UnitZ();
  bool may_slide = true;  ///< true: any other point of the line serves as well
};

/// Moves points along their lines so that the chain from the first to the last of them is nearly as short as possible,
/// and returns the shift of each [m]. The result depends on the lines alone, if all but the ends may slide.
///
/// Each step minimises the sum of squares with each piece weighted by the inverse of its length before (Weiszfeld
/// 1937), so the sum of lengths never grows. The first step starts from the least sum of squares, which does not depend
/// on the given points.
std::vector<double> shortenChain(std::vector<ChainLine>& chain);

/// Shortens a chain that is more than twice its shortest length; any other stays as it is. Returns the shift of each
/// point [m].
std::vector<double> drawTogether(std::vector<ChainLine>& chain);

/// Returns the length of the chain from point to point [m].
[[nodiscard]] double chainLength(const std::vector<ChainLine>& chain);

}  // namespace tubeplan::deflection
