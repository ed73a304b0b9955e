// Search for the order and branches of the visits with the shortest travel time.
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
  /// Number of local kicks per visit. A count instead of a time limit makes runs reproducible.
  int kicks_per_visit = 30;
  int least_kicks = 20'000;    ///< smallest number of kicks, for small problems
  int most_kicks = 2'000'000;  ///< largest number of kicks, for large problems
  int neighbours = 8;          ///< number of nearest other visits that the local search may connect to a visit
  /// Routes that need at most this much work are ordered exactly (exact_order.hpp).
  double most_exact_work = kMostExactWork;
  /// If false, lower_bound and optimality_gap stay NaN. The bound ignores extra times, so a search repeated with other
  /// extra times does not need it again.
  bool with_bound = true;
  OneTreeOptions bound;
  /// A proved lower bound of the travel time that is known already [s]; NaN if there is none. It replaces the bound
  /// where the order found comes within `good_gap` of it.
  double known_bound = std::numeric_limits<double>::quiet_NaN();
  double good_gap = 0.01;  ///< as a fraction of the bound
  /// An order of all visits to start from; it is improved by local search and `start_kicks` kicks, without other
  /// starts. May be empty.
  std::vector<int> start;
  int start_kicks = 0;
  /// An order of all visits found earlier, used as an additional starting order of the search; may be empty.
  std::vector<int> hint;
  /// Called regularly from several threads. Once it returns true, the search ends early with its result so far.
  std::function<bool()> stop;
};

enum class VisitOrderStatus { kNotRun, kSolved, kForbiddenMove, kBadInput };

struct VisitOrder {
  VisitOrderStatus status = VisitOrderStatus::kNotRun;
  std::string reason;
  std::vector<int> order;     ///< indices of visits, first to last
  std::vector<int> branches;  ///< branches[k]: index of the branch at visit order[k]
  /// Travel time [s]: straight moves, including those from the start and to the end posture, plus extra times.
  double travel_time = std::numeric_limits<double>::quiet_NaN();
  double lower_bound = std::numeric_limits<double>::quiet_NaN();     ///< proved lower bound of the travel time [s]
  double optimality_gap = std::numeric_limits<double>::quiet_NaN();  ///< (travel_time - lower_bound) / lower_bound
};

/// Orders the visits by nearest-neighbour starts, 2-opt and Or-opt with neighbour lists, alternating with the exact
/// branch choice, and local double-bridge kicks. A few visits are ordered exactly. The same input and seed give the
/// same route, on any number of threads; `extra_time` is called from several threads at once.
[[nodiscard]] VisitOrder orderVisits(const Route& route, const VisitOrderOptions& options = {});

}  // namespace tubeplan::planner
