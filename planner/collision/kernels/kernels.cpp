#include "planner/collision/kernels/kernels.hpp"

#include <vector>

#include "deflection/revolute_chain/kernels.hpp"

namespace tubeplan::planner::kernels {

namespace one_lane {
void place(const PlainArm&, const BentShapes&, const PlacedRows&);
void nearest(const PlainScene&, const double*, const FoundPairs&);
}  // namespace one_lane
namespace two_lanes {
void place(const PlainArm&, const BentShapes&, const PlacedRows&);
void nearest(const PlainScene&, const double*, const FoundPairs&);
}  // namespace two_lanes
#ifdef TUBEPLAN_X86_KERNELS
namespace four_lanes {
void place(const PlainArm&, const BentShapes&, const PlacedRows&);
void nearest(const PlainScene&, const double*, const FoundPairs&);
}  // namespace four_lanes
namespace eight_lanes {
void place(const PlainArm&, const BentShapes&, const PlacedRows&);
void nearest(const PlainScene&, const double*, const FoundPairs&);
}  // namespace eight_lanes
#endif

namespace {

constexpr Kernel kAll[] = {
    {1, one_lane::place, one_lane::nearest},
    {2, two_lanes::place, two_lanes::nearest},
#ifdef TUBEPLAN_X86_KERNELS
    {4, four_lanes::place, four_lanes::nearest},
    {8, eight_lanes::place, eight_lanes::nearest},
#endif
};

}  // namespace

std::span<const Kernel> kernels() { return std::span(kAll).first(deflection::simd::kernels().size()); }

}  // namespace tubeplan::planner::kernels
