// The quickest order of a few visits, with their postures: dynamic programming over sets of visits (Held and Karp
// 1962), with a state for each posture. Internal to the planning of visits.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "planner/order/posture_table.hpp"

namespace tubeplan::planner {

/// Largest work of an exact order: sets of visits times pairs of postures. It takes some hundredths of a second.
inline constexpr double kMostExactWork = 2e7;

[[nodiscard]] bool isForExactOrder(const PostureTable& table, double most_work = kMostExactWork);

/// Return the times [s] of the moves between all postures, symmetric: along straight lines, or with their extra times.
[[nodiscard]] Eigen::MatrixXd straightTimes(const PostureTable& table);
[[nodiscard]] Eigen::MatrixXd timesWithExtra(const PostureTable& table);

struct ExactOrder {
  /// Postures of the table, in travelling order; with start and end posture if there are any.
  std::vector<int> postures;
  double time = std::numeric_limits<double>::quiet_NaN();  ///< [s]
};

/// Finds the quickest of all orders. `zones` has one number for each visit: all of a zone come before any of the next.
/// Empty: any order is allowed.
[[nodiscard]] ExactOrder exactOrder(const PostureTable& table, const Eigen::MatrixXd& times,
                                    const std::vector<int>& zones = {});

}  // namespace tubeplan::planner
