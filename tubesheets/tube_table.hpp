// Hole maps and work lists as tables: the meaning of each column, and the tube of each row.
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
  bool is_state = false;  ///< a column of kState, whose words must be known
};

/// A table with columns for row and column, or for a tube's name.
struct TubeTable {
  TextTable text;
  std::map<TubeColumn, std::size_t> places;  ///< index of each known column; kNote has no entry
  std::vector<CodeColumn> codes;             ///< columns of states and codes, in the order of the table
  std::vector<std::string> unread;           ///< names of unknown columns
  const LengthUnit* unit_x = nullptr;        ///< unit of x; null if there is no x, or its unit is not stated
  const LengthUnit* unit_y = nullptr;
  std::optional<Problem> problem;  ///< first fault; the other members are then not to be used

  [[nodiscard]] bool has(TubeColumn column) const { return places.contains(column); }
  /// Returns the heading of a column, which must exist.
  [[nodiscard]] const std::string& nameOf(TubeColumn column) const { return text.columns[places.at(column)]; }
  /// Returns the field of a row; empty if there is no such column or the field holds a mark for "nothing".
  [[nodiscard]] std::string field(const CsvRow& row, TubeColumn column) const;
  /// Returns "left out of planning: exam, probe"; empty if every column is known.
  [[nodiscard]] std::string unreadText() const;
};

/// Reads the columns of a tube table. Faults: those of the text, no column for the tube, a column twice under any of
/// its names, x and y in two units, a name one letter longer or shorter than a known one.
[[nodiscard]] TubeTable parseTubeTable(std::string_view text);

/// The meaning that a user assigns to a column, whatever its heading.
struct ChosenTubeColumn {
  TubeColumn column = TubeColumn::kNote;
  std::size_t place = 0;             ///< index in the table
  const LengthUnit* unit = nullptr;  ///< unit of x or y; null: the unit stated above the table
};

/// Returns the table of a text whose headings may be unknown. It begins below a known heading, else at the first row
/// with a number, else below the first line.
[[nodiscard]] TextTable parseTubeText(std::string_view text);

/// Returns a tube table with the chosen columns and no others. Faults: no column for the tube, one quantity in two
/// columns, x and y in two units.
[[nodiscard]] TubeTable tubeTableOf(TextTable text, const std::vector<ChosenTubeColumn>& chosen);

enum class TubeTextStatus { kNotRun, kRead, kRefused };

/// Common part of hole maps and work lists as read; each adds the content of its rows.
struct TubeText {
  TubeTextStatus status = TubeTextStatus::kNotRun;
  std::optional<Problem> problem;  ///< first fault, when refused
  std::vector<std::string> notes;  ///< a sentence for each thing left out or taken only once
  std::string text;                ///< source text
  TubeTable table;

  /// Refuses the text for a problem, unless it is already refused.
  void refuse(const std::optional<Problem>& other);
  /// Calls `readRow` for each row up to the first fault. Refuses a text without rows, with `what` naming the rows
  /// expected.
  void readRows(std::string_view what, const std::function<void(const CsvRow&)>& readRow);
  /// Adds a note on the columns left out, and those of `more` that are not empty, unless the text is refused.
  void addNotes(const std::vector<std::string>& more);
};

/// The tube of a row; a problem if it has none, or if its columns name two.
struct NamedTube {
  RowAndColumn tube;
  std::optional<Problem> problem;
};
[[nodiscard]] NamedTube tubeOf(const TubeTable& table, const CsvRow& row);

/// A length in a column of x or y [m]; nothing if the field is empty; a problem if it is no number.
struct ReadLength {
  std::optional<double> metres;
  std::optional<Problem> problem;
};
[[nodiscard]] ReadLength lengthOf(const TubeTable& table, const CsvRow& row, TubeColumn axis);

/// Combined meaning of the codes of a row.
struct ReadCodes {
  std::optional<TubeState> state;
  bool is_done = false;
  std::vector<std::string> unknown;  ///< unknown words in columns of codes, kept as remarks
  std::optional<Problem> problem;    ///< an unknown state, or two different ones
};
[[nodiscard]] ReadCodes codesOf(const TubeTable& table, const CsvRow& row);

/// Returns unknown codes with their counts: "XYZ (2 rows), ABC"; empty if there are none.
[[nodiscard]] std::string unknownCodesText(const std::map<std::string, int>& counts);

}  // namespace tubeplan::tubesheets
