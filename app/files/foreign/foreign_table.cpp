#include "app/files/foreign/foreign_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "app/files/foreign/foreign_heading.hpp"
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
    std::string_view line = text.substr(start, end - start);
    if (line.ends_with('\r')) line.remove_suffix(1);
    line = tubesheets::trimBlanks(line);
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

/// "1.190" or "1,190": one thousand and some, or one and some.
bool isAmbiguous(const std::string& field, char mark) {
  const std::size_t at = field.find(mark);
  if (at == std::string::npos || field.size() != at + 4) return false;
  const std::size_t digits = at - (field.front() == '-' || field.front() == '+' ? 1 : 0);
  return digits >= 1 && digits <= 3 && tubesheets::parseNumber(withPoint(field)).has_value();
}

/// Whether a number has this mark, and not where thousands would have it.
bool hasDecimals(const std::string& field, char mark) {
  return field.find(mark) != std::string::npos && !isAmbiguous(field, mark) &&
         tubesheets::parseNumber(withPoint(field)).has_value();
}

/// Fields as they are written: a number that could have thousands apart where others have decimals so is not guessed
/// at.
void refuseThousands(const std::vector<ForeignRow>& rows, std::size_t first, const std::string& file) {
  const auto isAnywhere = [&](char mark) {
    return std::any_of(rows.begin() + static_cast<std::ptrdiff_t>(first), rows.end(), [&](const ForeignRow& row) {
      return std::any_of(row.fields.begin(), row.fields.end(),
                         [&](const std::string& field) { return hasDecimals(field, mark); });
    });
  };
  for (const auto& [decimal, other] : {std::pair{',', '.'}, std::pair{'.', ','}}) {
    if (!isAnywhere(decimal)) continue;
    for (std::size_t k = first; k < rows.size(); ++k)
      for (const auto& field : rows[k].fields)
        if (isAmbiguous(field, other))
          throw InputError(fmt::format("{}:{}", file, rows[k].line),
                           fmt::format("{} where other numbers have a decimal {}", inQuotes(field),
                                       decimal == ',' ? "comma" : "point"),
                           "numbers written alike", "export them without separators of thousands");
  }
}

bool isNumber(const std::string& field, char separator) {
  return tubesheets::parseNumber(separator == ',' ? field : withPoint(field)).has_value();
}

bool hasNumbers(const std::vector<std::string>& fields, char separator) {
  return std::any_of(fields.begin(), fields.end(),
                     [&](const std::string& field) { return isNumber(field, separator); });
}

std::vector<ForeignRow> rowsOf(const std::vector<Line>& lines, char separator, const std::string& file) {
  std::vector<ForeignRow> rows;
  for (const auto& line : lines) {
    auto fields = fieldsOf(line.text, separator);
    if (!fields) throw InputError(fmt::format("{}:{}", file, line.number), "an unclosed quote", "one that is");
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

/// A row of units below the headings, put behind them: "X" over "mm" is "X [mm]".
bool joinUnits(const ForeignRow& units, std::vector<std::string>& names) {
  bool has_any = false;
  std::vector<std::string> joined = names;
  for (std::size_t c = 0; c < joined.size(); ++c) {
    std::string_view unit = tubesheets::trimBlanks(units.fields[c]);
    if (unit.size() > 1 && std::string_view("[(").find(unit.front()) != std::string_view::npos)
      unit = tubesheets::trimBlanks(unit.substr(1, unit.size() - 2));
    if (unit.empty() || unit == "-") continue;
    if (!findUnitWord(unit)) return false;
    has_any = true;
    joined[c] += fmt::format(" [{}]", unit);
  }
  if (has_any) names = std::move(joined);
  return has_any;
}

/// The line before the first row with numbers, or that above it where it is of units, if it has a field for each
/// column.
void setHeading(const std::vector<ForeignRow>& rows, std::size_t first, std::size_t width, ForeignTable& table) {
  const auto isWide = [&](std::size_t above) { return first >= above && rows[first - above].fields.size() == width; };
  if (!isWide(1)) return;
  table.has_heading = true;
  table.columns = rows[first - 1].fields;
  table.heading_line = rows[first - 1].line;
  if (!isWide(2)) return;
  auto names = rows[first - 2].fields;
  if (!joinUnits(rows[first - 1], names)) return;
  table.columns = std::move(names);
  table.heading_line = rows[first - 2].line;
}

/// The names in the last comment before the rows, if it has one for each column.
std::vector<std::string> namesInComment(const std::vector<Line>& comments, int first_line, char separator,
                                        std::size_t width) {
  const Line* last = nullptr;
  for (const Line& comment : comments)
    if (comment.number < first_line) last = &comment;
  if (!last) return {};
  const std::size_t begin = std::min(last->text.find_first_not_of("#%/"), last->text.size());
  const std::string_view text = tubesheets::trimBlanks(last->text.substr(begin));
  const auto fields = fieldsOf(text, separator);
  const bool are_names = fields && fields->size() == width && !hasNumbers(*fields, separator);
  return are_names ? *fields : std::vector<std::string>{};
}

}  // namespace

bool isBlankField(std::string_view field) {
  return field.empty() || field == "-" || field == "--" || field == "NaN" || field == "nan" || field == "n/a" ||
         field == "N/A";
}

ForeignTable parseForeignTable(std::string_view text, const std::string& file) {
  ForeignTable table;
  table.file = file;
  std::vector<Line> lines, comments, of_units;
  for (const auto& line : linesOf(text))
    (statesUnits(line.text) ? of_units : isComment(line.text) ? comments : lines).push_back(line);
  for (const auto& comment : comments) table.lines_before.emplace_back(comment.text);
  const char separator = separatorOf(lines, file);
  const std::size_t width = usualWidth(lines, separator).first;
  auto rows = rowsOf(lines, separator, file);
  const auto isFirst = [&](const ForeignRow& row) {
    return row.fields.size() == width && hasNumbers(row.fields, separator);
  };
  const auto first = static_cast<std::size_t>(std::find_if(rows.begin(), rows.end(), isFirst) - rows.begin());
  if (first == rows.size())
    throw InputError(file, "no row with a number in it", "readings", "export the readings as text or CSV");
  requireEven(rows, first, width, file);
  if (separator != ',') {
    refuseThousands(rows, first, file);
    for (std::size_t k = first; k < rows.size(); ++k)
      for (auto& field : rows[k].fields) field = withPoint(std::move(field));
  }
  setHeading(rows, first, width, table);
  if (!table.has_heading) {
    table.columns = namesInComment(comments, rows[first].line, separator, width);
    table.has_heading = !table.columns.empty();
  }
  if (!table.has_heading) table.columns = countedNames(width);
  for (std::size_t k = 0; k < first; ++k)
    if (rows[k].line < table.heading_line || table.heading_line == 0) table.lines_before.emplace_back(lines[k].text);
  for (const auto& line : of_units) table.lines_before.emplace_back(line.text);
  table.units = statedUnits(table.lines_before, file);
  table.rows.assign(std::make_move_iterator(rows.begin() + static_cast<std::ptrdiff_t>(first)),
                    std::make_move_iterator(rows.end()));
  return table;
}

}  // namespace tubeplan::app
