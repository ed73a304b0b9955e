// The quickest order of a few visits, and their postures with it: dynamic programming over sets of visits (Held and
// Karp 1962), with a state for each posture to stand in. Internal to the planning of visits.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "planner/order/posture_table.hpp"

namespace tubeplan::planner {

/// Sets of visits times pairs of postures: what an exact order costs. So much takes some hundredths of a second.
inline constexpr double kMostExactWork = 2e7;

[[nodiscard]] bool isForExactOrder(const PostureTable& table, double most_work = kMostExactWork);

/// Times [s] of the moves between all postures, symmetric: along straight lines, or with what they cost extra.
[[nodiscard]] Eigen::MatrixXd straightTimes(const PostureTable& table);
[[nodiscard]] Eigen::MatrixXd timesWithExtra(const PostureTable& table);

struct ExactOrder {
  std::vector<int> postures;  ///< of the table, as travelled; start and end posture included where there are such
  double time = std::numeric_limits<double>::quiet_NaN();  ///< s
};

/// The quickest of all orders. `zones` has one number for each visit: all of a zone come before any of the next; empty:
/// any order will do.
[[nodiscard]] ExactOrder exactOrder(const PostureTable& table, const Eigen::MatrixXd& times,
                                    const std::vector<int>& zones = {});

}  // namespace tubeplan::planner
