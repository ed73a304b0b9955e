#include "planner/collision/kernels/kernels.hpp"

#include <cassert>

#include "deflection/revolute_chain/kernels.hpp"

namespace tubeplan::planner::kernels {

namespace one_lane {
void nearest(const PlainScene&, const double*, const FoundPairs&);
}  // namespace one_lane
namespace two_lanes {
void nearest(const PlainScene&, const double*, const FoundPairs&);
}  // namespace two_lanes
#ifdef TUBEPLAN_X86_KERNELS
namespace four_lanes {
void nearest(const PlainScene&, const double*, const FoundPairs&);
}  // namespace four_lanes
namespace eight_lanes {
void nearest(const PlainScene&, const double*, const FoundPairs&);
}  // namespace eight_lanes
#endif

namespace {

constexpr Kernel kAll[] = {
    {1, one_lane::nearest},
    {2, two_lanes::nearest},
#ifdef TUBEPLAN_X86_KERNELS
    {4, four_lanes::nearest},
    {8, eight_lanes::nearest},
#endif
};

}  // namespace

std::span<const Kernel> kernels() { return std::span(kAll).first(deflection::simd::kernels().size()); }

const Kernel& kernelOf(int lanes) {
  for (const Kernel& kernel : kernels())
    if (kernel.lanes == lanes) return kernel;
  assert(false);
  return kernels().front();
}

}  // namespace tubeplan::planner::kernels
