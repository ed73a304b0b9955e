// Hole maps as CSV text with the columns row,column,x_in,y_in,state, or in the layouts of other programs.
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

/// Content of a hole map, in the order of its rows. `leg` is set if the map has a column for the leg.
struct HoleMap : TubeText {
  std::vector<Tube> tubes;  ///< tubes of the map; tube k belongs to row k of the table
  std::optional<Leg> leg;
};

/// Writes one line per hole in sheet order. Numbers have the fewest digits that are read back to the same bits. If the
/// sheet was read from a map, keeps the map's comments and other columns. If that map is separated by commas and has
/// the columns row, column, state, and x and y in `unit`, it is written as it was read; only codes in its state column
/// are replaced by states.
[[nodiscard]] std::string formatHoleMap(const Sheet& sheet, const LengthUnit& unit = kInch);

/// Reads a hole map (text_table.hpp). Requires columns for row and column, or for the tube's name, and for x and y with
/// their unit: in the heading, in a row below the heading, or in a line before the table ("Units: mm"). Columns for
/// state or status (missing or empty: open), code and leg are optional. Columns may be in any order and under any of
/// their usual names (tube_columns.cpp); a note lists all other columns. Refuses repeated or missing columns, x and y
/// in different units, coordinates that are not finite numbers, an unknown state, the same tube twice, two legs in one
/// map, and a map without holes. findSheetProblems() checks whether the holes form a valid sheet.
[[nodiscard]] HoleMap parseHoleMap(std::string_view text);

}  // namespace tubeplan::tubesheets
