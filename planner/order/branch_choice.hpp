// The best posture at each tube for a given order of visits, and the usual row-by-row order.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "planner/order/route.hpp"

namespace tubeplan::planner {

enum class BranchChoiceStatus { kNotRun, kSolved, kForbiddenMove, kBadInput };

struct BranchChoice {
  BranchChoiceStatus status = BranchChoiceStatus::kNotRun;
  std::string reason;
  std::vector<int> branches;  ///< index of the branch chosen for each visit, in the order of visits
  /// Travel time [s], including extra times and the moves from the start and to the end posture; infinite if all
  /// choices contain a forbidden move.
  double travel_time = std::numeric_limits<double>::quiet_NaN();
};

/// Finds the branches that minimise the travel time of the given order, exactly (shortest path through the layers of
/// postures). `order` lists visits, each at most once, and need not contain all visits.
[[nodiscard]] BranchChoice bestBranches(const Route& route, const std::vector<int>& order);

class PostureTable;

/// Chooses a posture for each node so that the total time is as short as possible. `node_order` has the nodes of the
/// table in order, with start and end nodes if there are any. Returns the time [s], with `kForbiddenTime` for each
/// forbidden move.
double choosePostures(const PostureTable& table, const std::vector<int>& node_order, std::vector<int>& posture_of_node);

/// Returns the order of visits with the start node added before it and the end node after it, if there are any.
[[nodiscard]] std::vector<int> withEndNodes(const PostureTable& table, const std::vector<int>& order);

/// Returns the visits in order of their rows, with the direction reversed in every second row. `rows` and `columns`
/// have the row and the column of each visit.
[[nodiscard]] std::vector<int> serpentineOrder(const std::vector<int>& rows, const std::vector<int>& columns);

}  // namespace tubeplan::planner
