#include "planner/order/kept_order.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <map>

#include "planner/order/posture_table.hpp"

namespace tubeplan::planner {

namespace {

/// Returns the time of the quickest straight move between any branches of two visits [s].
double between(const PostureTable& table, int a, int b) {
  double least = std::numeric_limits<double>::infinity();
  for (int p = table.first(a); p < table.last(a); ++p)
    least = std::min(least, table.straight(p, table.nearestPosture(p, b)));
  return least;
}

/// Returns the index at which inserting the visit adds the least time. An index equal to the size of the order appends
/// the visit.
std::size_t cheapestPlace(const PostureTable& table, const std::vector<int>& order, int visit) {
  std::vector<double> to(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) to[k] = between(table, order[k], visit);
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t place = 0; place <= order.size(); ++place) {
    double extra = 0;
    if (place > 0) extra += to[place - 1];
    if (place < order.size()) extra += to[place];
    if (place > 0 && place < order.size()) extra -= between(table, order[place - 1], order[place]);
    if (extra >= least) continue;
    least = extra;
    best = place;
  }
  return best;
}

}  // namespace

std::vector<int> keptOrder(const Route& route, const std::vector<int>& tubes, const std::vector<int>& tubes_before,
                           double most_added) {
  assert(tubes.size() == route.visits.size());
  std::map<int, int> visit_of;
  for (std::size_t k = 0; k < tubes.size(); ++k) visit_of[tubes[k]] = static_cast<int>(k);
  std::vector<int> order;
  for (const int tube : tubes_before)
    if (const auto found = visit_of.find(tube); found != visit_of.end()) {
      order.push_back(found->second);
      visit_of.erase(found);
    }
  if (order.empty() || static_cast<double>(visit_of.size()) > most_added * static_cast<double>(tubes.size())) return {};
  const PostureTable table(route);
  for (const auto& [tube, visit] : visit_of)
    order.insert(order.begin() + static_cast<std::ptrdiff_t>(cheapestPlace(table, order, visit)), visit);
  return order;
}

int countNewNeighbours(const std::vector<int>& order, const std::vector<int>& tubes,
                       const std::vector<int>& tubes_before) {
  std::map<int, std::size_t> place;
  for (std::size_t k = 0; k < tubes_before.size(); ++k) place[tubes_before[k]] = k;
  int count = 0;
  for (std::size_t k = 0; k + 1 < order.size(); ++k) {
    const auto a = place.find(tubes[static_cast<std::size_t>(order[k])]);
    const auto b = place.find(tubes[static_cast<std::size_t>(order[k + 1])]);
    const bool were_neighbours =
        a != place.end() && b != place.end() && (a->second + 1 == b->second || b->second + 1 == a->second);
    count += !were_neighbours;
  }
  return count;
}

}  // namespace tubeplan::planner
