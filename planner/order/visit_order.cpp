#include "planner/order/visit_order.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <random>

#include "planner/order/branch_choice.hpp"
#include "planner/order/exact_order.hpp"
#include "planner/order/start_tours.hpp"
#include "planner/order/tour_search.hpp"

namespace tubeplan::planner {
namespace {

constexpr double kTrialShare = 0.08;   // fraction of all kicks for each start tour
constexpr double kMostFullTrials = 6;  // number of start tours above which each has fewer kicks
constexpr double kFinishShare = 0.32;  // fraction of all kicks for the best start tour
constexpr double kFewBranches = 4;     // mean number of branches per visit above which there are fewer kicks
constexpr long kKicksBetweenStops = 1000;
constexpr int kLegs = 8;  // number of rounds of kicks; each round ends with an exact branch choice

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

// Alternates local search and exact branch choice until neither reduces the time.
Candidate settled(const PostureTable& table, TourSearch& search, Candidate candidate) {
  for (;;) {
    search.restart(candidate.order, candidate.posture_of_node);
    search.improve();
    Candidate next = withBestPostures(table, search.order());
    if (!(next.time < candidate.time - 1e-9)) return candidate;
    candidate = std::move(next);
  }
}

bool isStopped(const VisitOrderOptions& options) { return options.stop && options.stop(); }

Candidate kicked(const PostureTable& table, TourSearch& search, const Candidate& candidate, long kicks,
                 std::mt19937_64& random, const VisitOrderOptions& options) {
  search.restart(candidate.order, candidate.posture_of_node);
  for (long done = 0; done < kicks && !isStopped(options); done += kKicksBetweenStops)
    search.kick(std::min(kKicksBetweenStops, kicks - done), random);
  Candidate next = settled(table, search, withBestPostures(table, search.order()));
  return next.time < candidate.time ? next : candidate;
}

/// Runs a short search from each start tour, in parallel, and returns the best result. Each search has its own seed, so
/// that the result does not depend on the threads.
Candidate bestOfTrials(const PostureTable& table, const std::vector<std::vector<Neighbour>>& neighbours, long kicks,
                       const VisitOrderOptions& options) {
  auto tours = startTours(table, neighbours);
  if (!options.hint.empty()) tours.push_back(options.hint);
  const double share = kTrialShare * std::min(1., kMostFullTrials / static_cast<double>(tours.size()));
  std::vector<Candidate> found(tours.size());
  oneapi::tbb::parallel_for(std::size_t{0}, tours.size(), [&](std::size_t k) {
    TourSearch search(table, neighbours);
    std::mt19937_64 random(options.seed + k);
    const Candidate start = settled(table, search, withBestPostures(table, tours[k]));
    found[k] = kicked(table, search, start, std::lround(share * static_cast<double>(kicks)), random, options);
  });
  return std::move(*std::ranges::min_element(found, {}, &Candidate::time));
}

Candidate finished(const PostureTable& table, const std::vector<std::vector<Neighbour>>& neighbours, Candidate best,
                   long kicks, const VisitOrderOptions& options) {
  TourSearch search(table, neighbours);
  std::mt19937_64 random(options.seed);
  for (int leg = 0; leg < kLegs; ++leg) best = kicked(table, search, best, kicks / kLegs, random, options);
  return best;
}

double boundOf(const Route& route, const VisitOrderOptions& options, double known_time) {
  if (known_time <= (1 + options.good_gap) * options.known_bound) return options.known_bound;
  OneTreeOptions bound = options.bound;
  bound.known_time = known_time < kForbiddenTime ? known_time : std::numeric_limits<double>::infinity();
  bound.stop = options.stop;
  return std::fmax(oneTreeBound(route, bound).lower_bound, options.known_bound);
}

struct Searched {
  Candidate best;
  double lower_bound = std::numeric_limits<double>::quiet_NaN();
};

/// Returns the number of kicks. A kick tries every branch of the visits near it, so fewer kicks are made if there are
/// many branches.
long kicksFor(const PostureTable& table, const VisitOrderOptions& options) {
  const long kicks = std::clamp<long>(static_cast<long>(options.kicks_per_visit) * table.visits(), options.least_kicks,
                                      std::max(options.least_kicks, options.most_kicks));
  const double branches = static_cast<double>(table.postures()) / table.visits();
  return std::lround(static_cast<double>(kicks) * std::min(1., std::sqrt(kFewBranches / branches)));
}

/// Searches for an order and, in parallel, computes the bound, which needs only a travel time close to the best.
Searched searched(const Route& route, const PostureTable& table, const VisitOrderOptions& options) {
  const auto neighbours = nearestNeighbours(table, options.neighbours);
  const long kicks = kicksFor(table, options);
  Searched result;
  if (options.start.empty()) {
    result.best = bestOfTrials(table, neighbours, kicks, options);
  } else {
    TourSearch search(table, neighbours);
    std::mt19937_64 random(options.seed);
    result.best = settled(table, search, withBestPostures(table, options.start));
    const long most = std::lround((kTrialShare + kFinishShare) * static_cast<double>(kicks));
    const long few = std::min<long>(options.start_kicks, most);
    if (few > 0) result.best = kicked(table, search, result.best, few, random, options);
  }
  const double known_time = result.best.time;
  oneapi::tbb::parallel_invoke(
      [&] {
        if (!options.start.empty()) return;
        const long finish_kicks = std::lround(kFinishShare * static_cast<double>(kicks));
        result.best = finished(table, neighbours, std::move(result.best), finish_kicks, options);
      },
      [&] {
        if (options.with_bound) result.lower_bound = boundOf(route, options, known_time);
      });
  return result;
}

/// Orders the visits exactly; the quickest order of straight moves is the best possible lower bound.
Searched exact(const Route& route, const PostureTable& table, const VisitOrderOptions& options) {
  const ExactOrder order = exactOrder(table, timesWithExtra(table));
  Searched result;
  result.best = {{}, std::vector<int>(table.nodes(), -1), order.time};
  for (const int posture : order.postures) {
    const int node = table.nodeOf(posture);
    if (node < table.visits()) result.best.order.push_back(node);
    result.best.posture_of_node[node] = posture;
  }
  if (options.with_bound)
    result.lower_bound = route.extra_time ? exactOrder(table, straightTimes(table)).time : order.time;
  return result;
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
  PostureTable table(route);
  assert(options.start.empty() || options.start.size() == route.visits.size());
  assert(options.hint.empty() || options.hint.size() == route.visits.size());
  const bool is_exact = isForExactOrder(table, options.most_exact_work);
  if (!is_exact) table.tabulate();
  const auto [best, lower_bound] = is_exact ? exact(route, table, options) : searched(route, table, options);
  result.order = best.order;
  for (const int visit : best.order) result.branches.push_back(best.posture_of_node[visit] - table.first(visit));
  result.travel_time = best.time;
  result.status = VisitOrderStatus::kSolved;
  if (best.time >= kForbiddenTime) {
    result.status = VisitOrderStatus::kForbiddenMove;
    result.reason = "no order was found without a forbidden move";
    result.travel_time = std::numeric_limits<double>::infinity();
  }
  result.lower_bound = lower_bound;
  if (lower_bound > 0) result.optimality_gap = (result.travel_time - lower_bound) / lower_bound;
  if (result.travel_time <= lower_bound) result.optimality_gap = 0;
  return result;
}

}  // namespace tubeplan::planner
