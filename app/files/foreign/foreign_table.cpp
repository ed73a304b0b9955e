#include "app/files/foreign/foreign_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "app/files/input_error.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

constexpr char kBlanks = ' ';  // any number of blanks and tabs between two fields
constexpr double kMostLinesAlike = 0.5;

struct Line {
  int number = 0;
  std::string_view text;
};

bool isComment(std::string_view line) {
  return line.starts_with('#') || line.starts_with("//") || line.starts_with('%');
}

std::vector<Line> linesOf(std::string_view text) {
  std::vector<Line> lines;
  int number = 0;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    const std::string_view line = tubesheets::trimBlanks(text.substr(start, end - start));
    ++number;
    if (!line.empty()) lines.push_back({number, line});
    start = end + 1;
  }
  return lines;
}

std::optional<std::vector<std::string>> fieldsOf(std::string_view line, char separator) {
  if (separator != kBlanks) return tubesheets::splitCsvLine(line, separator);
  std::vector<std::string> fields;
  for (std::size_t start = 0; (start = line.find_first_not_of(" \t", start)) != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(" \t", start), line.size());
    fields.emplace_back(line.substr(start, end - start));
    start = end;
  }
  return fields;
}

/// How many fields most lines have, and how many lines that is.
std::pair<std::size_t, std::size_t> usualWidth(const std::vector<Line>& lines, char separator) {
  std::map<std::size_t, std::size_t> counts;
  for (const auto& line : lines)
    if (const auto fields = fieldsOf(line.text, separator)) ++counts[fields->size()];
  std::pair<std::size_t, std::size_t> usual{0, 0};
  for (const auto& [width, count] : counts)
    if (width > 1 && count > usual.second) usual = {width, count};
  return usual;
}

/// The first separator that most lines have the same number of.
char separatorOf(const std::vector<Line>& lines, const std::string& file) {
  for (const char separator : {'\t', ';', ',', kBlanks}) {
    const auto [width, count] = usualWidth(lines, separator);
    if (width > 1 && static_cast<double>(count) >= kMostLinesAlike * static_cast<double>(lines.size()))
      return separator;
  }
  throw InputError(file, "lines that form no table",
                   "rows of equally many fields, separated by tab, semicolon, comma or blanks",
                   "export the readings as text or CSV");
}

/// "12,5" as "12.5"; any other text as it is.
std::string withPoint(std::string field) {
  const std::size_t comma = field.find(',');
  if (comma == std::string::npos || field.find(',', comma + 1) != std::string::npos) return field;
  std::string number = field;
  number[comma] = '.';
  return tubesheets::parseNumber(number) ? number : field;
}

std::size_t numbersIn(const std::vector<std::string>& fields) {
  return static_cast<std::size_t>(std::count_if(fields.begin(), fields.end(), [](const std::string& field) {
    return tubesheets::parseNumber(field).has_value();
  }));
}

bool isData(const ForeignRow& row) { return numbersIn(row.fields) >= 1; }

std::vector<ForeignRow> rowsOf(const std::vector<Line>& lines, char separator, const std::string& file) {
  std::vector<ForeignRow> rows;
  for (const auto& line : lines) {
    auto fields = fieldsOf(line.text, separator);
    if (!fields) throw InputError(fmt::format("{}:{}", file, line.number), "an unclosed quote", "one that is");
    if (separator != ',')
      for (auto& field : *fields) field = withPoint(std::move(field));
    rows.push_back({line.number, std::move(*fields)});
  }
  return rows;
}

/// Every data row has as many fields as most; what comes before the first that has may be anything.
void requireEven(const std::vector<ForeignRow>& rows, std::size_t first, std::size_t width, const std::string& file) {
  for (std::size_t k = first; k < rows.size(); ++k)
    if (rows[k].fields.size() != width)
      throw InputError(fmt::format("{}:{}", file, rows[k].line), fmt::format("{} fields", rows[k].fields.size()),
                       fmt::format("{}, as the rows before it have", width), "correct the row or remove it");
}

std::vector<std::string> countedNames(std::size_t width) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= width; ++i) names.push_back(fmt::format("column {}", i));
  return names;
}

}  // namespace

ForeignTable parseForeignTable(std::string_view text, const std::string& file) {
  ForeignTable table;
  table.file = file;
  std::vector<Line> lines;
  for (const auto& line : linesOf(text))
    if (isComment(line.text))
      table.lines_before.emplace_back(line.text);
    else
      lines.push_back(line);
  const char separator = separatorOf(lines, file);
  const std::size_t width = usualWidth(lines, separator).first;
  auto rows = rowsOf(lines, separator, file);
  const auto isFirst = [&](const ForeignRow& row) { return row.fields.size() == width && isData(row); };
  const auto first = static_cast<std::size_t>(std::find_if(rows.begin(), rows.end(), isFirst) - rows.begin());
  if (first == rows.size())
    throw InputError(file, "no row with a number in it", "readings", "export the readings as text or CSV");
  requireEven(rows, first, width, file);
  table.has_heading = first > 0 && rows[first - 1].fields.size() == width;
  table.heading_line = table.has_heading ? rows[first - 1].line : 0;
  table.columns = table.has_heading ? rows[first - 1].fields : countedNames(width);
  for (std::size_t k = 0; k + (table.has_heading ? 1 : 0) < first; ++k) table.lines_before.emplace_back(lines[k].text);
  table.rows.assign(std::make_move_iterator(rows.begin() + static_cast<std::ptrdiff_t>(first)),
                    std::make_move_iterator(rows.end()));
  return table;
}

}  // namespace tubeplan::app
