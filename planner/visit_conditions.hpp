// What a visit must observe beside the tubes themselves: where the arm comes from and goes to, which tubes come first,
// how long it stays.
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <vector>

namespace tubeplan::planner {

struct VisitConditions {
  std::optional<Eigen::VectorXd> start, end;  ///< rad (m for a slide): at rest there before and after all visits
  /// Tubes (indices in the sheet): all of a zone are visited before any of the next. Tubes in no zone come last.
  std::vector<std::vector<int>> zones;
  double dwell = 0;                ///< s at each hole ...
  std::map<int, double> dwell_at;  ///< ... but for these tubes

  [[nodiscard]] double dwellAt(int tube) const;
};

/// The zone of each tube, from 0 and without gaps; zones of which no tube is there do not count.
[[nodiscard]] std::vector<int> zonesOf(const std::vector<int>& tubes, const VisitConditions& conditions);

}  // namespace tubeplan::planner
