// The quickest order of a few visits, with a posture for each: dynamic programming over sets of visits (Held and Karp
// 1962), with a state for each posture. Internal to the planning of visits.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "planner/order/posture_table.hpp"

namespace tubeplan::planner {

/// Limit on the work of an exact search, measured as the number of sets of visits times the number of pairs of
/// postures. This much work takes a few hundredths of a second.
inline constexpr double kMostExactWork = 2e7;

[[nodiscard]] bool isForExactOrder(const PostureTable& table, double most_work = kMostExactWork);

/// Return the times [s] of the moves between all postures as a symmetric matrix: along straight lines, or with extra
/// times added.
[[nodiscard]] Eigen::MatrixXd straightTimes(const PostureTable& table);
[[nodiscard]] Eigen::MatrixXd timesWithExtra(const PostureTable& table);

struct ExactOrder {
  /// Postures of the table in travel order, with the start and end postures if there are any.
  std::vector<int> postures;
  double time = std::numeric_limits<double>::quiet_NaN();  ///< travel time [s]
};

/// Finds the quickest of all permitted orders. `zones` has one number for each visit: all visits of a zone come before
/// any visit of a zone with a higher number. Empty means that any order is permitted.
[[nodiscard]] ExactOrder exactOrder(const PostureTable& table, const Eigen::MatrixXd& times,
                                    const std::vector<int>& zones = {});

}  // namespace tubeplan::planner
