// What a plan must observe beside its tubes, as the command line and the cell say it.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "planner/visit_conditions.hpp"

namespace tubeplan::app {

struct ConditionsRequest {
  std::string start, end;                 ///< `park` (the cell's), joint readings "A,B,...", or empty: anywhere
  std::vector<std::string> first;         ///< zones, each a selection of tubes or a CSV file, before all other tubes
  double dwell = 0;                       ///< s at each hole, where the work list does not say
  std::vector<std::string> columns = {};  ///< what those of work lists are, of the tubes and of zones
};

/// Throws InputError for postures that the arm cannot take, a park posture that the cell lacks, tubes that the sheet
/// lacks and stays that are no times. `dwell_at`: the work list's own stays [s], by tube.
[[nodiscard]] planner::VisitConditions conditionsOf(const ConditionsRequest& request, const Cell& cell,
                                                    std::map<int, double> dwell_at);

/// Start and end posture as text, the same for the same postures to the bit; and all other conditions.
[[nodiscard]] std::string endsText(const planner::VisitConditions& conditions);
[[nodiscard]] std::string conditionsText(const planner::VisitConditions& conditions);

}  // namespace tubeplan::app
