// Conditions of a plan in addition to its tubes, from the command line and the cell.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "planner/visit_conditions.hpp"

namespace tubeplan::app {

struct ConditionsRequest {
  /// `park` (the cell's posture), joint readings "A,B,...", or empty for any posture; `start` may also be a tube's
  /// name, which means the posture in which an earlier plan visits it.
  std::string start, end;
  std::vector<std::string> first;         ///< zones visited first, each given as a selection of tubes or a CSV file
  double dwell = 0;                       ///< dwell time at each hole [s], unless the work list states one
  std::vector<std::string> columns = {};  ///< assignments of columns in work lists, for the tubes and the zones
};

/// Returns the index of the start tube; std::nullopt if `start` is not a tube's name. Throws InputError for a
/// tube that is not on the sheet.
[[nodiscard]] std::optional<int> startTubeOf(const ConditionsRequest& request, const tubesheets::Sheet& sheet);

/// Returns the conditions of a plan; a start at a tube is left open. `dwell_at` has the dwell times stated by the work
/// list [s], keyed by tube index. Throws InputError for postures that the arm cannot take, for a missing park posture,
/// for tubes that do not exist, and for invalid dwell times.
[[nodiscard]] planner::VisitConditions conditionsOf(const ConditionsRequest& request, const Cell& cell,
                                                    std::map<int, double> dwell_at);

/// Returns a fingerprint of the start and end postures, at full precision; "anywhere" if neither is given.
[[nodiscard]] std::string endsText(const planner::VisitConditions& conditions);

/// Returns a fingerprint of the zones and dwell times, at full precision; "none" if there are none.
[[nodiscard]] std::string conditionsText(const planner::VisitConditions& conditions);

}  // namespace tubeplan::app
