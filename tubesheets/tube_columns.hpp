// The columns of hole maps and work lists, known by their headings.
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
  kTube,  ///< row and column in one word
  kX,
  kY,
  kLeg,
  kSheet,  ///< a sheet's fingerprint
  kSteamGenerator,
  kState,  ///< a state or a code, nothing else
  kCode,   ///< a code, a remark or a number
  kDwell,
  kVisit,    ///< place in the visiting order, written by a plan
  kOutcome,  ///< reason why there is no visit, written by a plan
  kNote,     ///< text for people, kept and not read
};

/// Returns true if the column holds lengths.
[[nodiscard]] constexpr bool isPlaceColumn(TubeColumn column) {
  return column == TubeColumn::kX || column == TubeColumn::kY;
}

/// Returns the column's name in messages: "row", "dwell_s".
[[nodiscard]] std::string_view nameOf(TubeColumn column);

/// Returns true if a word is a unit that such a column can have: of length, or seconds.
[[nodiscard]] bool isTubeUnit(std::string_view word);

/// Meaning of a heading. A unit of another kind makes the column unknown: "row (mm)" is no row.
struct TubeHeading {
  std::optional<TubeColumn> column;  ///< column of the heading; nothing if it is unknown
  std::string unit;                  ///< unit as written; empty if none is stated
};
[[nodiscard]] TubeHeading readTubeHeading(const std::string& heading);

/// Returns the known column whose name differs from the heading by one letter at its end: "legg", "stat". Such a column
/// was meant to be read, so that it must not be skipped.
[[nodiscard]] std::optional<TubeColumn> tubeColumnMeantBy(const std::string& heading);

/// Returns how completely the fields of a heading name a tube.
[[nodiscard]] HeadingRank rankTubeHeading(const std::vector<std::string>& fields);

/// A quantity that a user can assign to a column, in the order of the table of columns.
struct TubeQuantity {
  TubeColumn column;
  std::string_view name;                ///< "row", "dwell"
  std::vector<std::string_view> units;  ///< the units to choose from
};
[[nodiscard]] std::vector<TubeQuantity> tubeQuantities();

}  // namespace tubeplan::tubesheets
