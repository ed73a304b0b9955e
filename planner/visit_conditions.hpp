// Conditions of a plan in addition to the work list: start and end postures, zones to visit in order, and dwell times.
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <vector>

namespace tubeplan::planner {

struct VisitConditions {
  std::optional<Eigen::VectorXd> start, end;  ///< postures in which the arm rests before and after all visits [rad, m]
  /// Tubes (indices in the sheet) of each zone: all tubes of a zone are visited before any tube of the next zone. Tubes
  /// in no zone are visited last.
  std::vector<std::vector<int>> zones;
  double dwell = 0;                ///< dwell time at each hole [s]
  std::map<int, double> dwell_at;  ///< dwell times at single tubes [s], keyed by tube index; they replace `dwell`

  [[nodiscard]] double dwellAt(int tube) const;
};

/// Returns the zone of each tube, numbered from 0 without gaps; zones without any of these tubes are skipped.
[[nodiscard]] std::vector<int> zonesOf(const std::vector<int>& tubes, const VisitConditions& conditions);

}  // namespace tubeplan::planner
