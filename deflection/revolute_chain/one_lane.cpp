// The kernels for one posture at a time. CMakeLists.txt states the processor for which this file is compiled.
#define TUBEPLAN_LANES 1
#include "deflection/revolute_chain/inverse_kernel.hpp"
#include "deflection/revolute_chain/row_kernel.hpp"

namespace tubeplan::deflection::simd::one_lane {

void solve(const RevoluteArm& arm, const Postures& in, const Shapes& out) { solveShapes(arm, in, out); }

void place(const PlainArm& arm, const BentShapes& in, const RowFrames& out) { placeRows(arm, in, out); }

void meet(const RevoluteArm& arm, const Tool& tool, const Goals& goals, Reached& out) {
  meetGoals(arm, tool, goals, out);
}

}  // namespace tubeplan::deflection::simd::one_lane
