// Parser of comma-separated text into rows of fields under named columns. Each row keeps its line number. This module
// does not open files.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tubesheets/problem.hpp"

namespace tubeplan::tubesheets {

struct CsvRow {
  int line = 0;  ///< line number, starting from 1
  std::vector<std::string> fields;
};

/// A parsed table. Every row has as many fields as the header. Blank lines and lines that start with # are skipped.
/// Fields are trimmed. A field may be in double quotes; within them, "" means one quote.
struct CsvTable {
  std::vector<std::string> columns;
  int header_line = 0;
  std::vector<CsvRow> rows;
  std::optional<Problem> problem;  ///< first error; the other members are valid only if there is none

  /// Returns the index of the column with that name, or std::nullopt if there is none.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view column) const;
};

/// Parses comma-separated text. Sets `problem` for a missing header, a column name that is empty, repeated or a number,
/// a row with more or fewer fields than the header, a quote that is not closed, or a zero byte.
[[nodiscard]] CsvTable parseCsv(std::string_view text);

/// One line of the input, without its line ending.
struct TextLine {
  int number = 0;         ///< line number, starting from 1
  std::string_view text;  ///< line without leading and trailing blanks
  std::string_view raw;
};

/// Splits text into lines, empty ones included. A byte order mark at the start is skipped. Lines may end in LF or CRLF.
[[nodiscard]] std::vector<TextLine> textLines(std::string_view text);

/// Returns true if the line begins with #, // or %.
[[nodiscard]] bool isCommentLine(std::string_view line);

/// Returns the part of the line that each field occupies, including blanks and quotes but not the separators;
/// std::nullopt if a quote is not closed.
[[nodiscard]] std::optional<std::vector<std::string_view>> csvSpans(std::string_view line, char separator);

/// Returns the fields of one line, trimmed and without quotes; std::nullopt if a quote is not closed or is followed by
/// more text.
[[nodiscard]] std::optional<std::vector<std::string>> splitCsvLine(std::string_view line, char separator);

/// Parse the whole field as a finite number or as an integer; return std::nullopt if it is not one.
[[nodiscard]] std::optional<double> parseNumber(std::string_view field);
[[nodiscard]] std::optional<int> parseInteger(std::string_view field);

/// Returns `text` as a CSV field, in double quotes if it would otherwise be split, lose outer blanks or begin a
/// comment.
[[nodiscard]] std::string csvField(std::string_view text, char separator = ',');

/// Returns the text in double quotes; each quote inside the text is doubled.
[[nodiscard]] std::string csvQuoted(std::string_view text);

/// Returns the text without leading and trailing blanks (spaces and tabs).
[[nodiscard]] std::string_view trimBlanks(std::string_view text);

}  // namespace tubeplan::tubesheets
