// The shortest path along an arm from axis to axis: a measure of the arm's length that does not depend on how its rows
// are written.
#pragma once

#include <vector>

#include "deflection/scalar.hpp"

namespace tubeplan::deflection {

/// A point on a line [m] and the line's unit direction. The two ends of a chain are fixed points.
struct ChainLine {
  Eigen::Vector3d point, direction = Eigen::Vector3d::UnitZ();
  bool may_slide = true;  ///< true if the point may be replaced by any other point on the line
};

/// Moves points along their lines so that the chain from the first to the last point is nearly as short as possible,
/// and returns the shift of each point [m]. If all points but the ends may slide, the result depends on the lines
/// alone.
///
/// Each step minimises the sum of squared piece lengths, each weighted by the inverse of the piece's length before the
/// step (Weiszfeld 1937), so the sum of lengths never grows. The first step starts from the minimum of the unweighted
/// sum of squares, which does not depend on the given points.
std::vector<double> shortenChain(std::vector<ChainLine>& chain);

/// Shortens a chain that is more than twice its shortest length; other chains are unchanged. Returns the shift of each
/// point [m].
std::vector<double> drawTogether(std::vector<ChainLine>& chain);

/// Returns the length of the chain from point to point [m].
[[nodiscard]] double chainLength(const std::vector<ChainLine>& chain);

}  // namespace tubeplan::deflection
