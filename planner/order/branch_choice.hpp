// The best posture at each tube when the order is given, and the row-by-row order that practice would take.
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
  std::vector<int> branches;  ///< by place in the order
  double travel_time =
      std::numeric_limits<double>::quiet_NaN();  ///< s, with start, end and extra times; infinite if forbidden
};

/// The branches that make the given order quickest, exactly (shortest path through the layers of postures).
/// `order` names visits, each at most once; it may leave visits out.
[[nodiscard]] BranchChoice bestBranches(const Route& route, const std::vector<int>& order);

class PostureTable;

/// The same on prepared data: nodes of the route in order, start and end nodes included where given. Writes the chosen
/// posture of each node of the order; gives the time [s], where a forbidden move counts `kForbiddenTime`.
double choosePostures(const PostureTable& table, const std::vector<int>& node_order, std::vector<int>& posture_of_node);

/// The order of visits with the start and end nodes put where they belong.
[[nodiscard]] std::vector<int> withEndNodes(const PostureTable& table, const std::vector<int>& order);

/// Row after row, every second row backwards. One row and column number for each visit.
[[nodiscard]] std::vector<int> serpentineOrder(const std::vector<int>& rows, const std::vector<int>& columns);

}  // namespace tubeplan::planner
