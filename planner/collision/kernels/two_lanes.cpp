// The clearance kernels, two postures at a time. See CMakeLists.txt for the processor that this is compiled for.
#define TUBEPLAN_LANES 2
#include "planner/collision/kernels/nearest_kernel.hpp"

namespace tubeplan::planner::kernels::two_lanes {

void nearest(const PlainScene& scene, const double* frames, const FoundPairs& out) { findNearest(scene, frames, out); }

}  // namespace tubeplan::planner::kernels::two_lanes
