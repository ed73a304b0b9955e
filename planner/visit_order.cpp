#include "planner/visit_order.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <random>

#include "planner/branch_choice.hpp"
#include "planner/start_tours.hpp"
#include "planner/tour_search.hpp"

namespace tubeplan::planner {
namespace {

constexpr int kTryEveryOrderUpTo = 4;
constexpr double kTrialShare = 0.08;  // of all kicks, for each start tour; the best one gets the rest
constexpr long kKicksBetweenStops = 1000;
constexpr int kLegs = 8;  // stretches of kicks, each followed by the exact branch choice

struct Candidate {
  std::vector<int> order;
  std::vector<int> posture_of_node;
  double time = std::numeric_limits<double>::infinity();
};

Candidate withBestPostures(const PostureTable& table, const std::vector<int>& order) {
  Candidate candidate{order, std::vector<int>(table.nodes(), -1)};
  candidate.time = choosePostures(table, withEndNodes(table, order), candidate.posture_of_node);
  return candidate;
}

Candidate bestOfAllOrders(const PostureTable& table) {
  std::vector<int> order(table.visits());
  std::iota(order.begin(), order.end(), 0);
  Candidate best = withBestPostures(table, order);
  while (std::next_permutation(order.begin(), order.end())) {
    Candidate candidate = withBestPostures(table, order);
    if (candidate.time < best.time) best = std::move(candidate);
  }
  return best;
}

// Local search and exact branch choice in turn, until neither gains.
Candidate settled(const PostureTable& table, TourSearch& search, Candidate candidate) {
  for (;;) {
    search.restart(candidate.order, candidate.posture_of_node);
    search.improve();
    Candidate next = withBestPostures(table, search.order());
    if (!(next.time < candidate.time - 1e-9)) return candidate;
    candidate = std::move(next);
  }
}

bool shouldStop(const VisitOrderOptions& options) { return options.stop && options.stop(); }

Candidate kicked(const PostureTable& table, TourSearch& search, const Candidate& candidate, long kicks,
                 std::mt19937_64& random, const VisitOrderOptions& options) {
  search.restart(candidate.order, candidate.posture_of_node);
  for (long done = 0; done < kicks && !shouldStop(options); done += kKicksBetweenStops)
    search.kick(std::min(kKicksBetweenStops, kicks - done), random);
  Candidate next = settled(table, search, withBestPostures(table, search.order()));
  return next.time < candidate.time ? next : candidate;
}

Candidate searched(const PostureTable& table, const VisitOrderOptions& options) {
  const auto neighbours = nearestNeighbours(table, options.neighbours);
  TourSearch search(table, neighbours);
  if (!options.start.empty()) return settled(table, search, withBestPostures(table, options.start));
  auto tours = startTours(table, neighbours);
  if (!options.hint.empty()) tours.push_back(options.hint);
  const long kicks = std::clamp<long>(static_cast<long>(options.kicks_per_visit) * table.visits(), options.least_kicks,
                                      std::max(options.least_kicks, options.most_kicks));
  std::mt19937_64 random(options.seed);
  Candidate best;
  for (const std::vector<int>& tour : tours) {
    Candidate candidate = settled(table, search, withBestPostures(table, tour));
    candidate =
        kicked(table, search, candidate, static_cast<long>(kTrialShare * static_cast<double>(kicks)), random, options);
    if (candidate.time < best.time) best = std::move(candidate);
  }
  const double share = std::max(0.0, 1 - kTrialShare * static_cast<double>(tours.size()));
  for (int leg = 0; leg < kLegs; ++leg) {
    best = kicked(table, search, best, static_cast<long>(share * static_cast<double>(kicks) / kLegs), random, options);
  }
  return best;
}

void addBound(const Route& route, const VisitOrderOptions& options, VisitOrder& result) {
  OneTreeOptions bound = options.bound;
  bound.known_time = result.travel_time;
  bound.stop = options.stop;
  result.lower_bound = oneTreeBound(route, bound).lower_bound;
  if (result.lower_bound > 0) result.gap = (result.travel_time - result.lower_bound) / result.lower_bound;
  if (result.travel_time <= result.lower_bound) result.gap = 0;
}

}  // namespace

VisitOrder orderVisits(const Route& route, const VisitOrderOptions& options) {
  VisitOrder result;
  const std::vector<std::string> problems = findRouteProblems(route);
  if (!problems.empty()) {
    result.status = VisitOrderStatus::kBadInput;
    result.reason = problems.front();
    return result;
  }
  const PostureTable table(route);
  assert(options.start.empty() || options.start.size() == route.visits.size());
  assert(options.hint.empty() || options.hint.size() == route.visits.size());
  const Candidate best = table.visits() <= kTryEveryOrderUpTo ? bestOfAllOrders(table) : searched(table, options);
  result.order = best.order;
  for (const int visit : best.order) result.branches.push_back(best.posture_of_node[visit] - table.first(visit));
  result.travel_time = best.time;
  result.status = VisitOrderStatus::kSolved;
  if (best.time >= kForbiddenTime) {
    result.status = VisitOrderStatus::kForbiddenMove;
    result.reason = "no order was found that keeps clear of all moves that must not be made";
    result.travel_time = std::numeric_limits<double>::infinity();
  }
  if (options.with_bound) addBound(route, options, result);
  return result;
}

}  // namespace tubeplan::planner
