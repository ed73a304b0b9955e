#include "deflection/revolute_chain/kernels.hpp"

#include <vector>

namespace tubeplan::deflection::simd {

namespace one_lane {
void solve(const RevoluteArm&, const Postures&, const Shapes&);
void place(const PlainArm&, const BentShapes&, const RowFrames&);
void meet(const RevoluteArm&, const Tool&, const Goals&, Reached&);
}  // namespace one_lane
namespace two_lanes {
void solve(const RevoluteArm&, const Postures&, const Shapes&);
void place(const PlainArm&, const BentShapes&, const RowFrames&);
void meet(const RevoluteArm&, const Tool&, const Goals&, Reached&);
}  // namespace two_lanes
#ifdef TUBEPLAN_X86_KERNELS
namespace four_lanes {
void solve(const RevoluteArm&, const Postures&, const Shapes&);
void place(const PlainArm&, const BentShapes&, const RowFrames&);
void meet(const RevoluteArm&, const Tool&, const Goals&, Reached&);
}  // namespace four_lanes
namespace eight_lanes {
void solve(const RevoluteArm&, const Postures&, const Shapes&);
void place(const PlainArm&, const BentShapes&, const RowFrames&);
void meet(const RevoluteArm&, const Tool&, const Goals&, Reached&);
}  // namespace eight_lanes
#endif

namespace {

std::vector<Kernel> runnable() {
  std::vector<Kernel> found{{1, one_lane::solve, one_lane::place, one_lane::meet},
                            {2, two_lanes::solve, two_lanes::place, two_lanes::meet}};
#ifdef TUBEPLAN_X86_KERNELS
  if (__builtin_cpu_supports("avx2")) found.push_back({4, four_lanes::solve, four_lanes::place, four_lanes::meet});
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
    found.push_back({8, eight_lanes::solve, eight_lanes::place, eight_lanes::meet});
#endif
  return found;
}

}  // namespace

std::span<const Kernel> kernels() {
  static const std::vector<Kernel> kFound = runnable();
  return kFound;
}

const Kernel& kernelFor(int count) {
  for (const Kernel& kernel : kernels())
    if (kernel.lanes >= count) return kernel;
  return kernels().back();
}

}  // namespace tubeplan::deflection::simd
