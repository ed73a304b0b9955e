// Conditions of a visit besides the tubes themselves: start and end of the arm, tubes that come first, and stays.
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <vector>

namespace tubeplan::planner {

struct VisitConditions {
  std::optional<Eigen::VectorXd> start, end;  ///< postures at rest before and after all visits [rad (m for a slide)]
  /// Tubes (indices in the sheet) by zone: all of a zone are visited before any of the next. Tubes in no zone come
  /// last.
  std::vector<std::vector<int>> zones;
  double dwell = 0;                ///< stay at each hole [s]
  std::map<int, double> dwell_at;  ///< stays of single tubes, which replace `dwell` [s]

  [[nodiscard]] double dwellAt(int tube) const;
};

/// Returns the zone of each tube, from 0 and without gaps; zones without any of the tubes do not count.
[[nodiscard]] std::vector<int> zonesOf(const std::vector<int>& tubes, const VisitConditions& conditions);

}  // namespace tubeplan::planner
