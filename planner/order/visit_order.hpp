// Order and branches of the visits for the least travel time.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "planner/order/exact_order.hpp"
#include "planner/order/one_tree_bound.hpp"
#include "planner/order/route.hpp"

namespace tubeplan::planner {

struct VisitOrderOptions {
  std::uint64_t seed = 1;
  int kicks_per_visit = 30;    ///< local perturbations; the effort is a count, so that a run is repeatable
  int least_kicks = 20'000;    ///< least number of kicks, for small problems
  int most_kicks = 2'000'000;  ///< largest number of kicks, for large problems
  int neighbours = 8;          ///< number of other visits that a move of the local search may join to a visit
  double most_exact_work = kMostExactWork;  ///< largest work of problems that are solved exactly (exact_order.hpp)
  bool with_bound = true;  ///< false: lower_bound and gap stay NaN (the bound does not depend on extra times)
  OneTreeOptions bound;
  /// An order of all visits to start from; only local search improves it, and nothing else is tried.
  std::vector<int> start;
  /// An additional start of the search, if it is not empty: an order of all visits found before.
  std::vector<int> hint;
  /// Called now and then, from several threads. Once it returns true, the result is not the search's best.
  std::function<bool()> stop;
};

enum class VisitOrderStatus { kNotRun, kSolved, kForbiddenMove, kBadInput };

struct VisitOrder {
  VisitOrderStatus status = VisitOrderStatus::kNotRun;
  std::string reason;
  std::vector<int> order;     ///< visits, first to last
  std::vector<int> branches;  ///< branch at each place in the order: that of order[k]
  /// Straight moves and extra times, start and end included [s].
  double travel_time = std::numeric_limits<double>::quiet_NaN();
  double lower_bound = std::numeric_limits<double>::quiet_NaN();     ///< proved lower bound of the travel time [s]
  double optimality_gap = std::numeric_limits<double>::quiet_NaN();  ///< (travel_time - lower_bound) / lower_bound
};

/// Orders the visits by nearest-neighbour starts, 2-opt and Or-opt with neighbour lists, alternating with the exact
/// branch choice, and local double-bridge kicks. A few visits are ordered exactly. The same input and seed give the
/// same route, on any number of threads; `extra_time` is called from several at once.
[[nodiscard]] VisitOrder orderVisits(const Route& route, const VisitOrderOptions& options = {});

}  // namespace tubeplan::planner
