#include "planner/collision/travel_bound.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tubeplan::planner {
namespace {

/// For each link, returns the largest distance from the origin of its frame to any point of this link or of the links
/// beyond [m].
std::vector<double> reachesBeyond(std::span<const LinkReach> links) {
  std::vector<double> beyond(links.size());
  for (std::size_t i = links.size(); i-- > 0;) {
    const bool last = i + 1 == links.size();
    beyond[i] = std::max(links[i].body, last ? 0.0 : links[i].step + beyond[i + 1]);
  }
  return beyond;
}

}  // namespace

TravelBound travelBoundOf(std::span<const LinkReach> links, double factor) {
  assert(factor >= 1);
  const std::vector<double> beyond = reachesBeyond(links);
  std::vector<double> by_link(links.size());
  for (std::size_t i = 0; i < links.size(); ++i) {
    by_link[i] += links[i].joint == LinkReach::Joint::kPrismatic ? 1 : beyond[i];
    for (const auto& followed : links[i].follows)
      by_link[static_cast<std::size_t>(followed.row)] += std::abs(followed.ratio) * beyond[i];
  }
  std::vector<double> reach;
  for (std::size_t i = 0; i < links.size(); ++i)
    if (links[i].joint != LinkReach::Joint::kNone) reach.push_back(factor * by_link[i]);
  return {Eigen::Map<const Eigen::VectorXd>(reach.data(), static_cast<Eigen::Index>(reach.size()))};
}

}  // namespace tubeplan::planner
