// The columns of hole maps and work lists, recognised by their headings.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tubesheets/text_table.hpp"

namespace tubeplan::tubesheets {

/// Content of a column.
enum class TubeColumn {
  kRow,
  kColumn,
  kTube,  ///< row and column in one name, such as R12C34
  kX,
  kY,
  kLeg,
  kSheet,  ///< fingerprint of the sheet
  kSteamGenerator,
  kState,  ///< a state or a code; other text is refused
  kCode,   ///< a code, a remark or a number
  kDwell,
  kVisit,    ///< position in the visiting order, written by a plan
  kOutcome,  ///< reason why a tube is not visited, written by a plan
  kNote,     ///< text for people, kept but not interpreted
};

/// Returns true if the column holds coordinates, which are lengths.
[[nodiscard]] constexpr bool isPlaceColumn(TubeColumn column) {
  return column == TubeColumn::kX || column == TubeColumn::kY;
}

/// Returns the column's name for messages, such as "row" or "dwell_s".
[[nodiscard]] std::string_view nameOf(TubeColumn column);

/// Returns true if a word is a unit in which a column of a tube table can be: a unit of length, or seconds.
[[nodiscard]] bool isTubeUnit(std::string_view word);

/// Meaning of a column heading. A unit that does not fit makes the column unknown: "row (mm)" is not a row column.
struct TubeHeading {
  std::optional<TubeColumn> column;  ///< column that the heading names; std::nullopt if it is unknown
  std::string unit;                  ///< unit as written; empty if no unit is stated
};
[[nodiscard]] TubeHeading readTubeHeading(const std::string& heading);

/// Returns the known column whose name has one letter more or less at its end than the heading, as for "legg" or
/// "stat". Such a heading is probably misspelt, so its column must not be skipped silently.
[[nodiscard]] std::optional<TubeColumn> tubeColumnMeantBy(const std::string& heading);

/// Ranks fields as a heading: kWhole if they name a tube, or a row and a column; kPartial if they name only one of row
/// and column; else kNone.
[[nodiscard]] HeadingRank rankTubeHeading(const std::vector<std::string>& fields);

/// A quantity that a user can assign to a column. tubeQuantities() returns all of them, in the order of the table in
/// tube_columns.cpp.
struct TubeQuantity {
  TubeColumn column;
  std::string_view name;                ///< name of the quantity, such as "row" or "dwell"
  std::vector<std::string_view> units;  ///< units to choose from; empty if the quantity has no unit
};
[[nodiscard]] std::vector<TubeQuantity> tubeQuantities();

}  // namespace tubeplan::tubesheets
