// Comma-separated text as named columns of fields, each row with its line number. Text only: files are read elsewhere.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tubesheets/problem.hpp"

namespace tubeplan::tubesheets {

struct CsvRow {
  int line = 0;  ///< line number, counted from 1
  std::vector<std::string> fields;
};

/// A header and rows of as many fields. Blank lines and lines that start with # are skipped; fields are trimmed, and
/// may be in double quotes, where "" is a quote.
struct CsvTable {
  std::vector<std::string> columns;
  int header_line = 0;
  std::vector<CsvRow> rows;
  std::optional<Problem> problem;  ///< first fault; the other members are then not to be used

  /// Returns the index of that column, or nothing if there is none.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view column) const;
};

/// Parses comma-separated text. Faults: no header, an empty or repeated column name or a number in its place, a row
/// with more or fewer fields, an open quote, a zero byte.
[[nodiscard]] CsvTable parseCsv(std::string_view text);

/// One line of a text, without its end.
struct TextLine {
  int number = 0;         ///< line number, counted from 1
  std::string_view text;  ///< text without the blanks at both ends
  std::string_view raw;
};

/// Splits a text into lines, empty ones included, after a byte order mark; line ends are LF or CRLF.
[[nodiscard]] std::vector<TextLine> textLines(std::string_view text);

/// Returns true if the line begins with #, // or %.
[[nodiscard]] bool isCommentLine(std::string_view line);

/// Returns the parts of a line that hold its fields, blanks and quotes included, without the separators; nothing if a
/// quote is left open.
[[nodiscard]] std::optional<std::vector<std::string_view>> csvSpans(std::string_view line, char separator);

/// Returns the fields of one line, trimmed and without their quotes; nothing if a quote is left open or followed by
/// more text.
[[nodiscard]] std::optional<std::vector<std::string>> splitCsvLine(std::string_view line, char separator);

/// Return the whole field as a finite number, or as an integer; nothing if it is anything else.
[[nodiscard]] std::optional<double> parseNumber(std::string_view field);
[[nodiscard]] std::optional<int> parseInteger(std::string_view field);

/// Returns a text as a field, in double quotes where it could be taken for two fields or lose its blanks.
[[nodiscard]] std::string csvField(std::string_view text, char separator = ',');

/// Returns the text in double quotes, each quote inside it doubled.
[[nodiscard]] std::string csvQuoted(std::string_view text);

/// Returns the text without the blanks at both ends.
[[nodiscard]] std::string_view trimBlanks(std::string_view text);

}  // namespace tubeplan::tubesheets
