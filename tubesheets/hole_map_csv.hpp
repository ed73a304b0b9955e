// The hole map as comma-separated text: row,column,x_in,y_in,state. The unit is in the columns' names.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tubesheets/length_unit.hpp"
#include "tubesheets/problem.hpp"
#include "tubesheets/sheet.hpp"

namespace tubeplan::tubesheets {

enum class HoleMapStatus { kNotRun, kRead, kRefused };

/// What the text says, in its own order; or the first fault of it. The leg is known where the text has a column for it.
struct HoleMap {
  HoleMapStatus status = HoleMapStatus::kNotRun;
  std::optional<Problem> problem;  ///< when refused
  std::vector<Tube> tubes;
  std::optional<Leg> leg;
};

/// One line per hole in sheet order. Every number comes back to the same bits, and is as short as that allows.
[[nodiscard]] std::string formatHoleMap(const Sheet& sheet, const LengthUnit& unit = kInch);

/// Reads such text: columns row, column, x_UNIT, y_UNIT, optional state (missing or empty: open), leg and comment, in
/// any order. Refused: unknown, missing or repeated columns, x and y in two units, anything that is not a finite
/// number, the same tube twice, two legs in one map, no holes. Whether the holes make a sheet is for findSheetProblems.
[[nodiscard]] HoleMap parseHoleMap(std::string_view text);

}  // namespace tubeplan::tubesheets
