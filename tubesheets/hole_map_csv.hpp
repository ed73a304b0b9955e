// The hole map as text: row,column,x_in,y_in,state, or the layouts of other programs.
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

/// Content of a hole map, in the order of the text. The leg is known where the text has a column for it.
struct HoleMap : TubeText {
  std::vector<Tube> tubes;  ///< tube k is that of row k of the table
  std::optional<Leg> leg;
};

/// Writes one line per hole in sheet order. Every number is read back to the same bits, and is as short as that allows.
/// A sheet read from a map keeps its comments and its other columns. A map in this program's own layout (commas,
/// columns row, column, x and y in that unit, state) is written as its own text, with the words for states alone
/// changed where it has codes.
[[nodiscard]] std::string formatHoleMap(const Sheet& sheet, const LengthUnit& unit = kInch);

/// Reads a hole map (text_table.hpp). It needs columns for row and column, or for the tube's name, and for x and y with
/// their unit: in the heading, in a row below it or in a line before ("Units: mm"). Optional are state or status
/// (missing or empty: open), code and leg. Columns come in any order and under any of their usual names
/// (tube_table.cpp); other columns are noted. Refused: repeated or missing columns, x and y in two units, anything that
/// is not a finite number, an unknown state, the same tube twice, two legs in one map, no holes. findSheetProblems()
/// checks whether the holes make a sheet.
[[nodiscard]] HoleMap parseHoleMap(std::string_view text);

}  // namespace tubeplan::tubesheets
