// In which order, and in which branch, to visit the tubes so that the arm travels the least time.
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
  int kicks_per_visit = 30;    ///< local perturbations tried; the effort is a count, so that a run repeats itself
  int least_kicks = 20'000;    ///< for small problems
  int most_kicks = 2'000'000;  ///< for great ones
  int neighbours = 8;          ///< of each visit that a move of the local search may join it to
  double most_exact_work = kMostExactWork;  ///< smaller problems are solved exactly (exact_order.hpp)
  bool with_bound = true;  ///< without: lower_bound and gap stay NaN (the bound does not depend on extra times)
  OneTreeOptions bound;
  /// An order of all visits to begin from: what local search gains on it is taken, and nothing else is tried.
  std::vector<int> start;
  /// One more tour to begin the search from, where it is not empty: an order of all visits found before.
  std::vector<int> hint;
  /// Asked now and then, from several threads; once true, what comes back is not the search's best.
  std::function<bool()> stop;
};

enum class VisitOrderStatus { kNotRun, kSolved, kForbiddenMove, kBadInput };

struct VisitOrder {
  VisitOrderStatus status = VisitOrderStatus::kNotRun;
  std::string reason;
  std::vector<int> order;     ///< visits, first to last
  std::vector<int> branches;  ///< by place in the order: branch at order[k]
  double travel_time =
      std::numeric_limits<double>::quiet_NaN();  ///< s, straight moves and extra times; start and end included
  double lower_bound = std::numeric_limits<double>::quiet_NaN();     ///< s, proved
  double optimality_gap = std::numeric_limits<double>::quiet_NaN();  ///< (travel_time - lower_bound) / lower_bound
};

/// Nearest-neighbour starts, 2-opt and Or-opt with neighbour lists, the exact branch choice in turn with them, and
/// local double-bridge kicks. A few visits are ordered exactly. The same input and seed give the same route, on
/// any number of threads; `extra_time` is asked from several at once.
[[nodiscard]] VisitOrder orderVisits(const Route& route, const VisitOrderOptions& options = {});

}  // namespace tubeplan::planner
