#include "tubesheets/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace tubeplan::tubesheets {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// Returns the position of the closing quote of a field whose opening quote is at `start`; npos if there is none.
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
      return Problem{"header", fmt::format("column {} has no name", i + 1), "", "name every column", line};
    if (parseNumber(columns[i]))
      return Problem{"header", "the number " + columns[i], "names of columns", "add a header line", line};
    if (std::find(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(i), columns[i]) !=
        columns.begin() + static_cast<std::ptrdiff_t>(i))
      return Problem{"header", "the column \"" + columns[i] + "\" occurs twice", "", "rename or remove one of them",
                     line};
  }
  return std::nullopt;
}

void addLine(CsvTable& table, std::string_view text, int line) {
  std::optional<std::vector<std::string>> fields = splitCsvLine(text, ',');
  if (text.find('\0') != std::string_view::npos) {
    table.problem = Problem{"text", "a zero byte", "comma-separated text", "save the table as CSV", line};
  } else if (!fields) {
    table.problem = Problem{"text", "a quote is not closed", "", "write quotes in pairs around a field", line};
  } else if (table.columns.empty()) {
    table.columns = std::move(*fields);
    table.header_line = line;
    table.problem = findHeaderProblem(table.columns, line);
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

std::vector<TextLine> textLines(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::vector<TextLine> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    text.remove_prefix(std::min(end + 1, text.size()));
    lines.push_back({static_cast<int>(lines.size()) + 1, trimBlanks(line), line});
  }
  return lines;
}

bool isCommentLine(std::string_view line) {
  return line.starts_with('#') || line.starts_with("//") || line.starts_with('%');
}

std::optional<std::vector<std::string_view>> csvSpans(std::string_view line, char separator) {
  std::vector<std::string_view> spans;
  for (std::size_t start = 0;;) {
    const std::size_t first = std::min(line.find_first_not_of(separator == '\t' ? " " : " \t", start), line.size());
    std::size_t search = start;
    if (first < line.size() && line[first] == '"') {
      search = findClosingQuote(line, first);
      if (search == std::string_view::npos) return std::nullopt;
    }
    const std::size_t end = std::min(line.find(separator, search), line.size());
    spans.push_back(line.substr(start, end - start));
    if (end == line.size()) return spans;
    start = end + 1;
  }
}

std::optional<std::vector<std::string>> splitCsvLine(std::string_view line, char separator) {
  const auto spans = csvSpans(line, separator);
  if (!spans) return std::nullopt;
  std::vector<std::string> fields;
  for (const std::string_view span : *spans) {
    const std::string_view field = trimBlanks(span);
    const bool is_quoted = !field.empty() && field.front() == '"';
    if (is_quoted && (field.size() < 2 || field.back() != '"' || findClosingQuote(field, 0) != field.size() - 1))
      return std::nullopt;
    fields.push_back(is_quoted ? unquote(field) : std::string(field));
  }
  return fields;
}

CsvTable parseCsv(std::string_view text) {
  CsvTable table;
  for (const TextLine& line : textLines(text)) {
    if (!line.text.empty() && line.text.front() != '#') addLine(table, line.text, line.number);
    if (table.problem) break;
  }
  if (!table.problem && table.columns.empty())
    table.problem = Problem{"text", "there is no header line", "", "add a line with the names of the columns", 0};
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

std::string csvField(std::string_view text, char separator) {
  const bool is_plain = text.find(separator) == std::string_view::npos &&
                        text.find_first_of(",\"\n\r#") == std::string_view::npos &&
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

}  // namespace tubeplan::tubesheets
