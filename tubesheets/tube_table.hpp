// Hole maps and work lists as tables, with the meaning of each column and the tube of each row.
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

/// A column of states or codes in a tube table.
struct CodeColumn {
  std::size_t place = 0;
  bool is_state = false;  ///< true for a column of kState, whose fields must be known states or codes
};

/// A table with columns for row and column, or for a tube's name.
struct TubeTable {
  TextTable text;
  std::map<TubeColumn, std::size_t> places;  ///< index of each known column in the table; kNote has no entry
  std::vector<CodeColumn> codes;             ///< columns of states and codes, in the order of the table
  std::vector<std::string> unread;           ///< names of unknown columns
  const LengthUnit* unit_x = nullptr;        ///< unit of x; null if there is no x column, or if its unit is not stated
  const LengthUnit* unit_y = nullptr;
  std::optional<Problem> problem;  ///< first error; the other members are valid only if there is none

  [[nodiscard]] bool has(TubeColumn column) const { return places.contains(column); }
  /// Returns the heading of a column, which must exist in the table.
  [[nodiscard]] const std::string& nameOf(TubeColumn column) const { return text.columns[places.at(column)]; }
  /// Returns a row's field in a column; empty if there is no such column or if the field is a dash.
  [[nodiscard]] std::string field(const CsvRow& row, TubeColumn column) const;
  /// Returns a sentence that lists the columns that planning ignores; empty if every column is known.
  [[nodiscard]] std::string unreadText() const;
};

/// Reads the columns of a tube table. Sets `problem` for faults of the text, no column for the tube, two columns with
/// the same meaning, x and y in different units, or a heading one letter longer or shorter than a known name.
[[nodiscard]] TubeTable parseTubeTable(std::string_view text);

/// The meaning that a user assigns to a column, independent of the column's heading.
struct ChosenTubeColumn {
  TubeColumn column = TubeColumn::kNote;
  std::size_t place = 0;             ///< index of the column in the table
  const LengthUnit* unit = nullptr;  ///< unit of x or y; null means that the unit stated above the table is used
};

/// Parses a table whose headings may be unknown. The table begins below a known heading, else at the first row with a
/// number, else below the first line.
[[nodiscard]] TextTable parseTubeText(std::string_view text);

/// Returns a tube table with only the chosen columns. Sets `problem` if there is no column for the tube, if one
/// quantity is in two columns, or if x and y have different units.
[[nodiscard]] TubeTable tubeTableOf(TextTable text, const std::vector<ChosenTubeColumn>& chosen);

enum class TubeTextStatus { kNotRun, kRead, kRefused };

/// Base of hole maps and work lists that are read from text; derived types add the content of the rows.
struct TubeText {
  TubeTextStatus status = TubeTextStatus::kNotRun;
  std::optional<Problem> problem;  ///< first error; std::nullopt if the text was accepted
  std::vector<std::string> notes;  ///< one sentence for each kind of content that was ignored, or repeated and used
                                   ///< only once
  std::string text;                ///< text that the table was read from
  TubeTable table;

  /// Refuses the text because of the problem `other`, if there is one and the text is not already refused.
  void refuse(const std::optional<Problem>& other);
  /// Calls `readRow` for each row up to the first fault. Refuses a text without rows; `what` names the expected rows in
  /// the message.
  void readRows(std::string_view what, const std::function<void(const CsvRow&)>& readRow);
  /// Unless the text is refused, adds a note on the columns that are ignored, and all nonempty notes of `more`.
  void addNotes(const std::vector<std::string>& more);
};

/// The tube that a row names, or the problem found: the row names no tube, or its columns name two different tubes.
struct NamedTube {
  RowAndColumn tube;
  std::optional<Problem> problem;
};
[[nodiscard]] NamedTube tubeOf(const TubeTable& table, const CsvRow& row);

/// A length in the x or y column of a row [m]; std::nullopt if the field is empty; a problem if the field is not a
/// number.
struct ReadLength {
  std::optional<double> metres;
  std::optional<Problem> problem;
};
[[nodiscard]] ReadLength lengthOf(const TubeTable& table, const CsvRow& row, TubeColumn axis);

/// Combined meaning of all states and codes in a row.
struct ReadCodes {
  std::optional<TubeState> state;
  bool is_done = false;
  std::vector<std::string> unknown;  ///< unknown codes in columns of codes, kept as remarks
  std::optional<Problem> problem;    ///< an unknown state, or two different states
};
[[nodiscard]] ReadCodes codesOf(const TubeTable& table, const CsvRow& row);

/// Returns a sentence that lists unknown codes with their counts, such as "XYZ (2 rows), ABC"; empty if there are none.
[[nodiscard]] std::string unknownCodesText(const std::map<std::string, int>& counts);

}  // namespace tubeplan::tubesheets
