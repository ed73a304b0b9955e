// The hole map as text: row,column,x_in,y_in,state, or as other programs write it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tubesheets/length_unit.hpp"
#include "tubesheets/problem.hpp"
#include "tubesheets/sheet.hpp"
#include "tubesheets/tube_table.hpp"

namespace tubeplan::tubesheets {

/// What the text says, in its own order. The leg is known where the text has a column for it.
struct HoleMap : TubeText {
  std::vector<Tube> tubes;  ///< of row k of the table
  std::optional<Leg> leg;
};

/// One line per hole in sheet order. Every number comes back to the same bits, and is as short as that allows. A sheet
/// of a map keeps its comments and its other columns; where the map is written as this program writes it (commas, and
/// columns row, column, x and y of that unit, and state) it is the map's own text, with the words for states alone
/// changed where it has codes.
[[nodiscard]] std::string formatHoleMap(const Sheet& sheet, const LengthUnit& unit = kInch);

/// Reads such text (text_table.hpp): columns for row and column, or for the tube's name, x and y with their unit in the
/// heading, in a row below or in a line before ("Units: mm"), and, where wanted, state or status (missing or empty:
/// open), code and leg, in any order and under any of their usual names (tube_table.cpp); other columns are noted.
/// Refused: repeated or missing columns, x and y in two units, anything that is not a finite number, an unknown state,
/// the same tube twice, two legs in one map, no holes. Whether the holes make a sheet is for findSheetProblems.
[[nodiscard]] HoleMap parseHoleMap(std::string_view text);

}  // namespace tubeplan::tubesheets
