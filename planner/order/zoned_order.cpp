#include "planner/order/zoned_order.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

#include "planner/order/branch_choice.hpp"

namespace tubeplan::planner {

namespace {

int countZones(const std::vector<int>& zones) { return zones.empty() ? 0 : 1 + *std::ranges::max_element(zones); }

std::vector<int> visitsOf(const std::vector<int>& zones, int zone) {
  std::vector<int> visits;
  for (std::size_t k = 0; k < zones.size(); ++k)
    if (zones[k] == zone) visits.push_back(static_cast<int>(k));
  return visits;
}

/// Returns the route of one zone's visits, without ends and extra times.
Route partOf(const Route& route, const std::vector<int>& visits) {
  Route part;
  part.speeds = route.speeds;
  for (const int visit : visits) {
    part.visits.push_back(route.visits[static_cast<std::size_t>(visit)]);
    if (!route.with_extra.empty()) part.with_extra.push_back(route.with_extra[static_cast<std::size_t>(visit)]);
  }
  return part;
}

/// Returns the extra times of moves in the route of one zone, looked up in the whole route. The zone's start posture
/// is that of visit `before` in the whole route, which may be the whole route's start posture.
ExtraTime extraOf(const Route& route, const std::vector<int>& visits, int before, int branch_before) {
  if (!route.extra_time) return {};
  return [&extra_time = route.extra_time, visits, before, branch_before](int a, int branch_a, int b, int branch_b) {
    const auto translate = [&](int& visit, int& branch) {
      if (visit >= 0) visit = visits[static_cast<std::size_t>(visit)];
      if (visit != kStartPosture) return;
      visit = before;
      branch = branch_before;
    };
    translate(a, branch_a);
    translate(b, branch_b);
    return extra_time(a, branch_a, b, branch_b);
  };
}

/// Returns the zone's visits in the order that they have in `start`, as indices within the zone.
std::vector<int> startOf(const std::vector<int>& start, const std::vector<int>& visits) {
  std::vector<int> order;
  for (const int visit : start) {
    const auto found = std::ranges::lower_bound(visits, visit);
    if (found != visits.end() && *found == visit) order.push_back(static_cast<int>(found - visits.begin()));
  }
  return order;
}

/// Returns the time [s] of the quickest move from any posture in `from` to any posture in `to`.
double quickestWay(const Route& from, const Route& to) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& a : from.visits)
    for (const auto& b : to.visits)
      for (const auto& p : a.branches)
        for (const auto& q : b.branches) least = std::min(least, moveDuration(p, q, from.speeds));
  return least;
}

}  // namespace

VisitOrder orderByZones(const Route& route, const std::vector<int>& zones, const VisitOrderOptions& options) {
  assert(zones.size() == route.visits.size());
  const int count = countZones(zones);
  if (count <= 1) return orderVisits(route, options);
  VisitOrder combined;
  for (int zone = 0; zone < count; ++zone) {
    const std::vector<int> visits = visitsOf(zones, zone);
    Route part = partOf(route, visits);
    const int before = combined.order.empty() ? kStartPosture : combined.order.back();
    const int branch_before = combined.order.empty() ? 0 : combined.branches.back();
    part.start =
        combined.order.empty()
            ? route.start
            : std::optional(
                  route.visits[static_cast<std::size_t>(before)].branches[static_cast<std::size_t>(branch_before)]);
    if (zone + 1 == count) part.end = route.end;
    part.extra_time = extraOf(route, visits, before, branch_before);
    VisitOrderOptions ordering = options;
    ordering.start = startOf(options.start, visits);
    ordering.hint = startOf(options.hint, visits);
    ordering.with_bound = false;
    const VisitOrder order = orderVisits(part, ordering);
    if (order.status == VisitOrderStatus::kBadInput) return order;
    if (!order.reason.empty()) combined.reason = order.reason;
    for (const int visit : order.order) combined.order.push_back(visits[static_cast<std::size_t>(visit)]);
    combined.branches.insert(combined.branches.end(), order.branches.begin(), order.branches.end());
  }
  // The branches of each zone were chosen independently of the next zone, so choose all branches again.
  const BranchChoice together = bestBranches(route, combined.order);
  combined.branches = together.branches;
  combined.travel_time = together.travel_time;
  combined.status = together.status == BranchChoiceStatus::kForbiddenMove ? VisitOrderStatus::kForbiddenMove
                                                                          : VisitOrderStatus::kSolved;
  if (!options.with_bound) return combined;
  OneTreeOptions bound = options.bound;
  bound.stop = options.stop;
  combined.lower_bound = zonedBound(route, zones, bound);
  if (combined.lower_bound > 0)
    combined.optimality_gap = (combined.travel_time - combined.lower_bound) / combined.lower_bound;
  return combined;
}

double zonedBound(const Route& route, const std::vector<int>& zones, const OneTreeOptions& options) {
  const int count = countZones(zones);
  if (count <= 1) return oneTreeBound(route, options).lower_bound;
  double bound = 0;
  Route before;
  for (int zone = 0; zone < count; ++zone) {
    Route part = partOf(route, visitsOf(zones, zone));
    if (zone > 0) bound += quickestWay(before, part);
    before = part;
    if (zone == 0) part.start = route.start;
    if (zone + 1 == count) part.end = route.end;
    bound += oneTreeBound(part, options).lower_bound;
  }
  return bound;
}

double rowByRowTime(const Route& route, const std::vector<int>& zones, const std::vector<int>& rows,
                    const std::vector<int>& columns) {
  if (rows.size() != route.visits.size() || columns.size() != rows.size() || zones.size() != rows.size())
    return std::numeric_limits<double>::quiet_NaN();
  std::vector<int> order = serpentineOrder(rows, columns);
  std::ranges::stable_sort(order, {}, [&](int visit) { return zones[static_cast<std::size_t>(visit)]; });
  return bestBranches(route, order).travel_time;
}

}  // namespace tubeplan::planner
