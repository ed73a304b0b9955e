// Hole maps and work lists as tables: which column is which, and which tube a row is of.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tubesheets/length_unit.hpp"
#include "tubesheets/text_table.hpp"
#include "tubesheets/tube.hpp"
#include "tubesheets/tube_codes.hpp"

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

/// A column of states or codes.
struct CodeColumn {
  std::size_t place = 0;
  bool is_state = false;  ///< kState, which must be understood
};

/// A table with row and column, or a tube's name.
struct TubeTable {
  TextTable text;
  std::map<TubeColumn, std::size_t> places;  ///< where a column is; of kNote none
  std::vector<CodeColumn> codes;             ///< in their order
  std::vector<std::string> unread;           ///< names of columns of which nothing is known
  const LengthUnit* unit_x = nullptr;        ///< null where there is no x, or nobody says in which unit
  const LengthUnit* unit_y = nullptr;
  std::optional<Problem> problem;  ///< the first fault; then nothing else is to be used

  [[nodiscard]] bool has(TubeColumn column) const { return places.contains(column); }
  /// The heading of a column that is there.
  [[nodiscard]] const std::string& nameOf(TubeColumn column) const { return text.columns[places.at(column)]; }
  /// Empty where there is no such column, and where a mark stands for nothing.
  [[nodiscard]] std::string field(const CsvRow& row, TubeColumn column) const;
  /// "left out of planning: exam, probe"; empty where every column is known.
  [[nodiscard]] std::string unreadText() const;
};

/// Faults: those of the text, no column for the tube, a column twice under any of its names, x and y in two units, a
/// name that is one letter longer or shorter than a known one.
[[nodiscard]] TubeTable parseTubeTable(std::string_view text);

/// The tube of a row; a problem where it has none, or where its columns name two.
struct NamedTube {
  RowAndColumn tube;
  std::optional<Problem> problem;
};
[[nodiscard]] NamedTube tubeOf(const TubeTable& table, const CsvRow& row);

/// A length in a column of x or y [m]; nothing where it is empty; a problem where it is no number.
struct ReadLength {
  std::optional<double> metres;
  std::optional<Problem> problem;
};
[[nodiscard]] ReadLength lengthOf(const TubeTable& table, const CsvRow& row, TubeColumn axis);

/// What the codes of a row say together.
struct ReadCodes {
  std::optional<TubeState> state;
  bool is_done = false;
  std::vector<std::string> unknown;  ///< of columns of codes: kept as remarks
  std::optional<Problem> problem;    ///< an unknown state, or two that differ
};
[[nodiscard]] ReadCodes codesOf(const TubeTable& table, const CsvRow& row);

/// Codes that nobody knows, with how often they stand: "XYZ (2 rows), ABC"; empty where there are none.
[[nodiscard]] std::string unknownCodesText(const std::map<std::string, int>& counts);

}  // namespace tubeplan::tubesheets
