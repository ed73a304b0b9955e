// Conditions of a plan in addition to its tubes, from the command line and the cell.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "planner/visit_conditions.hpp"

namespace tubeplan::app {

struct ConditionsRequest {
  std::string start, end;          ///< `park` (the cell's), joint readings "A,B,...", or empty for any posture
  std::vector<std::string> first;  ///< zones to visit before all other tubes, each a selection of tubes or a CSV file
  double dwell = 0;                ///< dwell at each hole [s], unless the work list states one
  std::vector<std::string> columns = {};  ///< meanings of columns of work lists, for the tubes and the zones
};

/// Returns the conditions of a plan. `dwell_at` has the dwells of the work list [s], by tube. Throws InputError for
/// postures that the arm cannot take, a park posture or tubes that do not exist, and invalid dwells.
[[nodiscard]] planner::VisitConditions conditionsOf(const ConditionsRequest& request, const Cell& cell,
                                                    std::map<int, double> dwell_at);

/// Returns a fingerprint of the start and end posture, to the last bit; "anywhere" if there are none.
[[nodiscard]] std::string endsText(const planner::VisitConditions& conditions);

/// Returns a fingerprint of all other conditions, to the last bit; "none" if there are none.
[[nodiscard]] std::string conditionsText(const planner::VisitConditions& conditions);

}  // namespace tubeplan::app
