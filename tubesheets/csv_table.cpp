#include "tubesheets/csv_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>

namespace tubeplan::tubesheets {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr int kLargestNumber = 100000;

// The end of a quoted field that starts at `start` (its opening quote); npos when it is never closed.
std::size_t findClosingQuote(std::string_view line, std::size_t start) {
  for (std::size_t i = start + 1; i < line.size(); ++i) {
    if (line[i] != '"') continue;
    if (i + 1 < line.size() && line[i + 1] == '"')
      ++i;
    else
      return i;
  }
  return std::string_view::npos;
}

std::string unquote(std::string_view quoted) {
  std::string text;
  for (std::size_t i = 1; i + 1 < quoted.size(); ++i) {
    text += quoted[i];
    if (quoted[i] == '"') ++i;
  }
  return text;
}

std::optional<Problem> findHeaderProblem(const std::vector<std::string>& columns, int line) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].empty())
      return Problem{fmt::format("header, column {}", i + 1), "no name", "a name for every column", "", line};
    if (parseNumber(columns[i]))
      return Problem{"header", "the number " + columns[i], "names of columns", "add a header line", line};
    if (std::find(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(i), columns[i]) !=
        columns.begin() + static_cast<std::ptrdiff_t>(i))
      return Problem{"header", "the column \"" + columns[i] + "\" twice", "every column once", "", line};
  }
  return std::nullopt;
}

void addLine(CsvTable& table, std::string_view text, int line) {
  std::optional<std::vector<std::string>> fields = splitCsvLine(text, ',');
  if (text.find('\0') != std::string_view::npos) {
    table.problem = Problem{"text", "a zero byte", "comma-separated text", "save the table as CSV", line};
  } else if (!fields) {
    table.problem = Problem{"text", "an unclosed quote", "quotes in pairs around a field", "", line};
  } else if (table.columns.empty()) {
    table.columns = std::move(*fields);
    table.header_line = line;
    table.problem = findHeaderProblem(table.columns, line);
    for (const auto& [mark, name] : {std::pair{';', "semicolons"}, std::pair{'\t', "tabs"}})
      if (table.columns.size() == 1 && table.columns.front().find(mark) != std::string::npos)
        table.problem = Problem{"header", fmt::format("columns apart by {}", name), "commas between the columns",
                                "save the table as comma-separated", line};
  } else if (fields->size() != table.columns.size()) {
    table.problem = Problem{"row", fmt::format("{} fields", fields->size()),
                            fmt::format("{}, as in the header", table.columns.size()), "", line};
  } else {
    table.rows.push_back({line, std::move(*fields)});
  }
}

}  // namespace

std::optional<std::size_t> CsvTable::find(std::string_view column) const {
  const auto found = std::find(columns.begin(), columns.end(), column);
  if (found == columns.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns.begin());
}

std::optional<std::vector<std::string>> splitCsvLine(std::string_view line, char separator) {
  std::vector<std::string> fields;
  std::size_t start = 0;
  while (true) {
    const std::size_t first = std::min(line.find_first_not_of(separator == '\t' ? " " : " \t", start), line.size());
    std::size_t search = start;
    if (first < line.size() && line[first] == '"') {
      search = findClosingQuote(line, first);
      if (search == std::string_view::npos) return std::nullopt;
    }
    const std::size_t end = std::min(line.find(separator, search), line.size());
    const std::string_view field = trimBlanks(line.substr(start, end - start));
    const bool is_quoted = !field.empty() && field.front() == '"';
    if (is_quoted && (field.size() < 2 || field.back() != '"' || findClosingQuote(field, 0) != field.size() - 1))
      return std::nullopt;
    fields.push_back(is_quoted ? unquote(field) : std::string(field));
    if (end == line.size()) return fields;
    start = end + 1;
  }
}

CsvTable parseCsv(std::string_view text) {
  CsvTable table;
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  for (int line = 1; !text.empty() && !table.problem; ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view content = text.substr(0, end);
    if (content.ends_with('\r')) content.remove_suffix(1);
    text.remove_prefix(std::min(end + 1, text.size()));
    content = trimBlanks(content);
    if (!content.empty() && content.front() != '#') addLine(table, content, line);
  }
  if (!table.problem && table.columns.empty())
    table.problem = Problem{"text", "an empty file", "a header line with the columns' names", "", 0};
  return table;
}

CsvTable parseCsvOfAnyCase(std::string_view text) {
  CsvTable table = parseCsv(text);
  if (table.problem) return table;
  for (std::string& column : table.columns)
    std::transform(column.begin(), column.end(), column.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  table.problem = findHeaderProblem(table.columns, table.header_line);
  return table;
}

std::optional<double> parseNumber(std::string_view field) {
  double number = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), number);
  if (error != std::errc() || end != field.data() + field.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

std::optional<int> parseInteger(std::string_view field) {
  int number = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), number);
  if (error != std::errc() || end != field.data() + field.size()) return std::nullopt;
  return number;
}

std::string csvField(std::string_view text) {
  const bool is_plain = text.find_first_of(",\"\n\r#") == std::string_view::npos &&
                        (text.empty() || (text.front() != ' ' && text.back() != ' '));
  return is_plain ? std::string(text) : csvQuoted(text);
}

std::string csvQuoted(std::string_view text) {
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? std::string("\"\"") : std::string(1, c);
  return field + "\"";
}

std::string_view trimBlanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

TubeNumbers parseTubeNumbers(const CsvTable& table, const CsvRow& row) {
  TubeNumbers numbers;
  const auto parse = [&](std::string_view name, int& number) {
    const std::optional<std::size_t> place = table.find(name);
    assert(place.has_value());
    const std::string& field = row.fields[*place];
    number = parseInteger(field).value_or(0);
    if (numbers.problem || (number >= 1 && number <= kLargestNumber)) return;
    numbers.problem = Problem{std::string(name), "\"" + field + "\"",
                              fmt::format("a whole number from 1 to {}", kLargestNumber), "", row.line};
  };
  parse("row", numbers.row);
  parse("column", numbers.column);
  return numbers;
}

std::optional<Problem> findColumnProblem(const CsvTable& table, const std::vector<std::string>& known) {
  const std::string columns = fmt::format("{}", fmt::join(table.columns, ", "));
  for (const std::string name : {"row", "column"})
    if (!table.find(name))
      return Problem{"header", "columns " + columns, "a column \"" + name + "\"", "add it to the header",
                     table.header_line};
  for (const std::string& column : table.columns)
    if (std::find(known.begin(), known.end(), column) == known.end())
      return Problem{"header", "the column \"" + column + "\"", fmt::format("only {}", fmt::join(known, ", ")),
                     "rename or remove it", table.header_line};
  return std::nullopt;
}

}  // namespace tubeplan::tubesheets
