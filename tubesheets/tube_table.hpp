// Hole maps and work lists as tables: which column is which, and which tube a row is of.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tubesheets/length_unit.hpp"
#include "tubesheets/text_table.hpp"
#include "tubesheets/tube.hpp"
#include "tubesheets/tube_codes.hpp"
#include "tubesheets/tube_columns.hpp"

namespace tubeplan::tubesheets {

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

/// A column by what someone says that it is, whatever its heading.
struct ChosenTubeColumn {
  TubeColumn column = TubeColumn::kNote;
  std::size_t place = 0;             ///< in the table
  const LengthUnit* unit = nullptr;  ///< of x and y; null: as a line above the table states
};

/// Returns the table of a text whose headings need not be known: below a known heading, else at the first row with a
/// number, else below the first line.
[[nodiscard]] TextTable parseTubeText(std::string_view text);

/// Returns such a table with the columns that were chosen and no others. Faults: no column for the tube, one quantity
/// in two columns, x and y in two units.
[[nodiscard]] TubeTable tubeTableOf(TextTable text, const std::vector<ChosenTubeColumn>& chosen);

enum class TubeTextStatus { kNotRun, kRead, kRefused };

/// What hole maps and work lists are read into alike: each adds what its rows say.
struct TubeText {
  TubeTextStatus status = TubeTextStatus::kNotRun;
  std::optional<Problem> problem;  ///< when refused: the first fault
  std::vector<std::string> notes;  ///< what is left out of it, and what is taken once, a sentence each
  std::string text;                ///< what it was read from
  TubeTable table;

  /// Takes a problem where there has been none.
  void refuse(const std::optional<Problem>& other);
  /// Calls `readRow` for each row up to the first fault, and refuses a text without `what` its rows are of.
  void readRows(std::string_view what, const std::function<void(const CsvRow&)>& readRow);
  /// Adds what the table left out, and those that are not empty, where nothing was refused.
  void addNotes(const std::vector<std::string>& more);
};

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
