// The columns of hole maps and work lists: what each is called by its heading.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tubesheets/text_table.hpp"

namespace tubeplan::tubesheets {

/// What a column holds.
enum class TubeColumn {
  kRow,
  kColumn,
  kTube,  ///< both in one word
  kX,
  kY,
  kLeg,
  kSheet,  ///< a fingerprint
  kSteamGenerator,
  kState,  ///< a state or a code, none other
  kCode,   ///< a code, a remark or a number
  kDwell,
  kVisit,    ///< written by a plan: the place in its order
  kOutcome,  ///< written by a plan: why there is none
  kNote,     ///< for people: kept and not read
};

/// Returns whether a column holds lengths.
[[nodiscard]] constexpr bool isPlaceColumn(TubeColumn column) {
  return column == TubeColumn::kX || column == TubeColumn::kY;
}

/// Its name in messages: "row", "dwell_s".
[[nodiscard]] std::string_view nameOf(TubeColumn column);

/// Returns whether a word is a unit of such a column: of length, or seconds.
[[nodiscard]] bool isTubeUnit(std::string_view word);

/// What a heading says. A unit of another kind makes it that of something else: "row (mm)" is no row.
struct TubeHeading {
  std::optional<TubeColumn> column;  ///< nothing where the heading is not known
  std::string unit;                  ///< as it is written; empty where none is stated
};
[[nodiscard]] TubeHeading readTubeHeading(const std::string& heading);

/// Returns the column whose name is one letter longer or shorter at its end: "legg", "stat". What was meant to be read
/// is not left out.
[[nodiscard]] std::optional<TubeColumn> tubeColumnMeantBy(const std::string& heading);

/// Returns how much of a tube the fields of a heading name.
[[nodiscard]] HeadingRank rankTubeHeading(const std::vector<std::string>& fields);

/// A quantity that columns are chosen for, in the order of the table of columns.
struct TubeQuantity {
  TubeColumn column;
  std::string_view name;                ///< "row", "dwell"
  std::vector<std::string_view> units;  ///< of which one is to be stated
};
[[nodiscard]] std::vector<TubeQuantity> tubeQuantities();

}  // namespace tubeplan::tubesheets
