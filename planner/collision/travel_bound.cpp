#include "planner/collision/travel_bound.hpp"

#include <algorithm>
#include <cassert>

namespace tubeplan::planner {

TravelBound travelBoundOf(std::span<const LinkReach> links, double factor) {
  assert(factor >= 1);
  std::vector<double> reach;
  double beyond = 0;  // of any point past the frame in hand, from its origin
  for (std::size_t i = links.size(); i-- > 0;) {
    const bool last = i + 1 == links.size();
    beyond = std::max(links[i].body, last ? 0.0 : links[i].step + beyond);
    if (links[i].joint == LinkReach::Joint::kRevolute) reach.push_back(factor * beyond);
    if (links[i].joint == LinkReach::Joint::kPrismatic) reach.push_back(factor);
  }
  std::ranges::reverse(reach);
  return {Eigen::Map<const Eigen::VectorXd>(reach.data(), static_cast<Eigen::Index>(reach.size()))};
}

}  // namespace tubeplan::planner
