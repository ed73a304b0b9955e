#include "planner/remaining_bound.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "planner/order/branch_choice.hpp"

namespace tubeplan::planner {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kRounding = 1e-12;  // rounding error of a sum of times, as a fraction of it

/// Returns the tubes removed from the earlier plan, in its order, with all their branches; std::nullopt if
/// the reach of one of them is not known.
std::optional<VisitChoice> removedFrom(const PlanCache& cache, const VisitChoice& choice) {
  std::set<int> remaining;
  for (const TubeReach& tube : choice.reach) remaining.insert(tube.tube);
  std::vector<TubeReach> removed;
  for (const int tube : cache.visiting_order) {
    if (remaining.contains(tube)) continue;
    const auto known = cache.reach.find(tube);
    if (known == cache.reach.end() || known->second.branches.empty()) return std::nullopt;
    removed.push_back(known->second);
  }
  return allBranches(std::move(removed));
}

/// Returns the longest time that a straight move from `q` to any tube of `route` takes [s].
double longestMove(const Eigen::VectorXd& q, const Route& route) {
  double longest = 0;
  for (const Visit& visit : route.visits)
    for (const auto& posture : visit.branches) longest = std::max(longest, moveDuration(q, posture, route.speeds));
  return longest;
}

/// Returns the time [s] that suffices to visit the removed tubes before any route through the remaining tubes.
double timeBefore(const Route& removed, const Route& remaining) {
  std::vector<int> order(removed.visits.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<int>(k);
  if (order.empty() && !removed.start) return 0;
  if (order.empty())
    return remaining.start ? moveDuration(*removed.start, *remaining.start, remaining.speeds)
                           : longestMove(*removed.start, remaining);
  const BranchChoice through = bestBranches(removed, order);
  if (through.status != BranchChoiceStatus::kSolved) return kNone;
  if (removed.end) return through.travel_time;
  return through.travel_time +
         longestMove(removed.visits.back().branches[static_cast<std::size_t>(through.branches.back())], remaining);
}

}  // namespace

double remainingBound(const PlanContext& context, const VisitChoice& choice) {
  const KnownBound& known = context.cache.bound;
  const VisitConditions& conditions = context.options.conditions;
  if (!(known.lower_bound > 0) || (known.end && known.end != conditions.end)) return kNone;
  const auto removed = removedFrom(context.cache, choice);
  if (!removed) return kNone;
  Route before = routeOf(*removed, context.speeds, {});
  before.start = known.start;
  before.end = conditions.start;
  const double time = timeBefore(before, routeOf(choice, context.speeds, conditions));
  const double bound = known.lower_bound - time - kRounding * (known.lower_bound + time);
  return bound > 0 ? bound : kNone;
}

}  // namespace tubeplan::planner
