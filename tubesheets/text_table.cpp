#include "tubesheets/text_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <map>
#include <utility>

namespace tubeplan::tubesheets {
namespace {

constexpr char kBlanks = ' ';  // represents any number of blanks and tabs between two fields
constexpr std::array kMarks{'\t', ';', ',', '|'};
constexpr double kMostLinesAlike = 0.5;

std::string_view nameOfMark(char mark) {
  switch (mark) {
    case '\t':
      return "tabs";
    case ';':
      return "semicolons";
    case ',':
      return "commas";
    case '|':
      return "|";
    default:
      return "blanks";
  }
}

using Fields = std::vector<std::string>;

std::optional<Fields> splitFields(std::string_view line, char separator) {
  if (separator != kBlanks) return splitCsvLine(line, separator);
  Fields fields;
  for (std::size_t start = 0; (start = line.find_first_not_of(" \t", start)) != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(" \t", start), line.size());
    fields.emplace_back(line.substr(start, end - start));
    start = end;
  }
  return fields;
}

/// Returns a number such as "12,5" with a decimal point, and any other field unchanged.
std::string withPoint(std::string field) {
  const std::size_t comma = field.find(',');
  if (comma == std::string::npos || field.find(',', comma + 1) != std::string::npos) return field;
  std::string number = field;
  number[comma] = '.';
  return parseNumber(number) ? number : field;
}

/// Returns true for a number such as "1.190" or "1,190", whose punctuation mark may be a thousands or a decimal
/// separator.
bool isAmbiguous(const std::string& field, char mark) {
  const std::size_t at = field.find(mark);
  if (at == std::string::npos || field.size() != at + 4) return false;
  const std::size_t digits = at - (field.front() == '-' || field.front() == '+' ? 1 : 0);
  return digits >= 1 && digits <= 3 && parseNumber(withPoint(field)).has_value();
}

/// Returns true if `mark` in this number can only be a decimal separator, not a thousands separator.
bool hasDecimals(const std::string& field, char mark) {
  return field.find(mark) != std::string::npos && !isAmbiguous(field, mark) &&
         parseNumber(withPoint(field)).has_value();
}

bool hasNumbers(const Fields& fields, char separator) {
  return std::any_of(fields.begin(), fields.end(), [&](const std::string& field) {
    return parseNumber(separator == ',' ? field : withPoint(field)).has_value();
  });
}

std::string_view withoutCommentMark(std::string_view line) {
  return trimBlanks(line.substr(std::min(line.find_first_not_of("#%/"), line.size())));
}

/// Best heading found so far: the heading with the highest rank or, among equal ranks, the earliest.
struct FoundHeading {
  HeadingRank rank = HeadingRank::kNone;
  int line = 0;
  char separator = ',';
  Fields names;
};

class TableParser {
 public:
  TableParser(std::string_view text, const TableWords& words) : words_(words) {
    for (const TextLine& line : textLines(text)) {
      if (line.text.find('\0') != std::string_view::npos)
        refuse({"text", "a zero byte", "text", "save the table as text or CSV", line.number});
      if (line.text.empty()) continue;
      if (words.statesUnits && words.statesUnits(line.text))
        of_units_.emplace_back(line.text);
      else
        (isCommentLine(line.text) ? comments_ : lines_).push_back(line);
    }
    for (const auto& comment : comments_) table_.lines_before.emplace_back(comment.text);
  }

  TextTable parse() {
    if (table_.problem) return std::move(table_);
    if (words_.rankHeading)
      beginBelowHeading();
    else
      beginAtNumbers();
    std::ranges::move(of_units_, std::back_inserter(table_.lines_before));
    if (!table_.problem) requireEven();
    if (!table_.problem && table_.separator != ',') takeDecimalCommas();
    if (table_.problem) table_.rows.clear();
    return std::move(table_);
  }

 private:
  void refuse(Problem problem) {
    if (!table_.problem) table_.problem = std::move(problem);
  }

  /// Splits a line into fields. Tabs at the ends of the line separate empty fields only if the line has too few fields
  /// without them.
  [[nodiscard]] std::optional<Fields> fieldsIn(const TextLine& line, std::size_t width) const {
    auto fields = splitFields(line.text, table_.separator);
    if (table_.separator != '\t' || !fields || fields->size() >= width) return fields;
    auto all = splitFields(line.raw, table_.separator);
    return all && all->size() == width ? all : fields;
  }

  /// Returns one row for each line from index `first` on; stops at the first line with a quote that is not closed.
  std::vector<CsvRow> rowsFrom(std::size_t first, std::size_t width) {
    std::vector<CsvRow> rows;
    for (std::size_t k = first; k < lines_.size(); ++k) {
      auto fields = fieldsIn(lines_[k], width);
      if (!fields) {
        refuse({"row", "a quote is not closed", "", "write quotes in pairs around a field", lines_[k].number});
        return rows;
      }
      rows.push_back({lines_[k].number, std::move(*fields)});
    }
    return rows;
  }

  // Methods for a table with a known heading.

  /// Returns the heading with the best rank among the given lines.
  FoundHeading bestHeading(const std::vector<TextLine>& lines) const {
    FoundHeading best;
    for (const TextLine& line : lines) {
      for (const char mark : kMarks) {
        auto names = splitCsvLine(withoutCommentMark(line.text), mark);
        if (!names) continue;
        const HeadingRank rank = words_.rankHeading(*names);
        const bool is_wider = best.line == line.number && rank == best.rank && names->size() > best.names.size();
        if (rank > best.rank || is_wider) best = {rank, line.number, mark, std::move(*names)};
      }
      if (best.rank == HeadingRank::kWhole) break;
    }
    return best;
  }

  void beginBelowHeading() {
    FoundHeading heading = bestHeading(lines_);
    if (heading.rank != HeadingRank::kWhole)
      if (FoundHeading above = bestHeading(comments_); above.rank > heading.rank) heading = std::move(above);
    if (heading.rank == HeadingRank::kNone) return refuseHeadless();
    if (heading.names.size() == 1) heading.separator = ',';
    table_.has_heading = true;
    table_.heading_line = heading.line;
    table_.separator = heading.separator;
    table_.columns = std::move(heading.names);
    const auto below = std::find_if(lines_.begin(), lines_.end(),
                                    [&](const TextLine& line) { return line.number > table_.heading_line; });
    for (auto line = lines_.begin(); line != below; ++line)
      if (line->number != table_.heading_line) table_.lines_before.emplace_back(line->text);
    table_.rows = rowsFrom(static_cast<std::size_t>(below - lines_.begin()), table_.columns.size());
    if (!table_.rows.empty() && table_.rows.front().fields.size() == table_.columns.size() &&
        joinUnits(table_.rows.front().fields, table_.columns)) {
      table_.units_line = table_.rows.front().line;
      table_.rows.erase(table_.rows.begin());
    }
  }

  void refuseHeadless() {
    if (lines_.empty())
      return refuse({"text", "there is no header line", "", "add a line with the names of the columns", 0});
    const auto fields = splitCsvLine(lines_.front().text, ',');
    if (!fields)
      return refuse(
          {"header", "a quote is not closed", "", "write quotes in pairs around a field", lines_.front().number});
    const bool is_row = hasNumbers(*fields, ';');
    refuse({"header",
            is_row ? fmt::format("the first line is the row {}", lines_.front().text)
                   : std::string("no line names the columns \"row\" and \"column\", or \"tube\""),
            "",
            is_row ? "add a header line with \"row\" and \"column\", or \"tube\""
                   : "name the columns in one line above the rows",
            lines_.front().number});
  }

  // Methods for a table without a known heading, which is found by its rows of numbers.

  /// Returns the most common number of fields in a line, and the number of lines that have it.
  [[nodiscard]] std::pair<std::size_t, std::size_t> usualWidth(char separator) const {
    std::map<std::size_t, std::size_t> counts;
    for (const auto& line : lines_)
      if (const auto fields = splitFields(line.text, separator)) ++counts[fields->size()];
    std::pair<std::size_t, std::size_t> usual{0, 0};
    for (const auto& [width, count] : counts)
      if (width > 1 && count > usual.second) usual = {width, count};
    return usual;
  }

  /// Chooses the first separator that gives most lines the same number of fields. Returns that number, or 0 if there is
  /// none.
  std::size_t chooseSeparator() {
    for (const char separator : {'\t', ';', ',', '|', kBlanks}) {
      const auto [width, count] = usualWidth(separator);
      if (width <= 1 || static_cast<double>(count) < kMostLinesAlike * static_cast<double>(lines_.size())) continue;
      table_.separator = separator;
      return width;
    }
    return 0;
  }

  void beginAtNumbers() {
    const std::size_t width = chooseSeparator();
    if (width == 0)
      return refuse({"text",
                     "the lines form no table of equally many fields, separated by tab, semicolon, comma, | or blanks",
                     "", "export the readings as text or CSV", 0});
    std::vector<CsvRow> rows = rowsFrom(0, width);
    if (table_.problem) return;
    const auto isFirst = [&](const CsvRow& row) {
      return row.fields.size() == width && hasNumbers(row.fields, table_.separator);
    };
    const auto first = static_cast<std::size_t>(std::find_if(rows.begin(), rows.end(), isFirst) - rows.begin());
    if (first == rows.size())
      return refuse({"text", "no row has a number in it", "", "export the readings as text or CSV", 0});
    takeHeadingAbove(rows, first, width);
    if (!table_.has_heading) takeHeadingOfComment(rows[first].line, width);
    if (!table_.has_heading)
      for (std::size_t i = 1; i <= width; ++i) table_.columns.push_back(fmt::format("column {}", i));
    for (std::size_t k = 0; k < first; ++k)
      if (rows[k].line < table_.heading_line || table_.heading_line == 0)
        table_.lines_before.emplace_back(lines_[k].text);
    table_.rows.assign(std::make_move_iterator(rows.begin() + static_cast<std::ptrdiff_t>(first)),
                       std::make_move_iterator(rows.end()));
  }

  /// Takes the heading from the line before the first row with numbers or, if that line holds units, from the line
  /// above it. A heading needs a field for each column.
  void takeHeadingAbove(const std::vector<CsvRow>& rows, std::size_t first, std::size_t width) {
    const auto isWide = [&](std::size_t above) { return first >= above && rows[first - above].fields.size() == width; };
    if (!isWide(1)) return;
    table_.has_heading = true;
    table_.columns = rows[first - 1].fields;
    table_.heading_line = rows[first - 1].line;
    if (!isWide(2)) return;
    Fields names = rows[first - 2].fields;
    if (!joinUnits(rows[first - 1].fields, names)) return;
    table_.columns = std::move(names);
    table_.units_line = rows[first - 1].line;
    table_.heading_line = rows[first - 2].line;
  }

  /// Takes the heading from the last comment before the rows, if the comment has a name for each column.
  void takeHeadingOfComment(int first_line, std::size_t width) {
    const auto below = std::find_if(comments_.begin(), comments_.end(),
                                    [&](const TextLine& comment) { return comment.number > first_line; });
    if (below == comments_.begin()) return;
    auto names = splitFields(withoutCommentMark(std::prev(below)->text), table_.separator);
    if (!names || names->size() != width || hasNumbers(*names, table_.separator)) return;
    table_.has_heading = true;
    table_.columns = std::move(*names);
  }

  // Methods that set the heading and the units.

  /// Appends a row of units to the column names: "X" over "mm" becomes "X [mm]". Returns false if the row holds no
  /// units.
  bool joinUnits(const Fields& units, Fields& names) const {
    bool has_any = false;
    Fields joined = names;
    for (std::size_t c = 0; c < joined.size(); ++c) {
      std::string_view unit = trimBlanks(units[c]);
      if (unit.size() > 1 && std::string_view("[(").find(unit.front()) != std::string_view::npos)
        unit = trimBlanks(unit.substr(1, unit.size() - 2));
      if (unit.empty() || unit == "-") continue;
      if (!words_.isUnit(unit)) return false;
      has_any = true;
      joined[c] += fmt::format(" [{}]", unit);
    }
    if (has_any) names = std::move(joined);
    return has_any;
  }

  void requireEven() {
    const std::size_t width = table_.columns.size();
    for (const CsvRow& row : table_.rows)
      if (row.fields.size() != width)
        return refuse(
            {"row", fmt::format("{} fields", row.fields.size()),
             fmt::format("{}, as {}", width, words_.rankHeading ? "in the header" : "the rows before it have"),
             adviceFor(row), row.line});
  }

  [[nodiscard]] std::string adviceFor(const CsvRow& row) const {
    const auto line = std::lower_bound(lines_.begin(), lines_.end(), row.line,
                                       [](const TextLine& l, int number) { return l.number < number; });
    for (const char mark : kMarks) {
      const auto fields = splitCsvLine(line->text, mark);
      if (mark != table_.separator && table_.columns.size() > 1 && fields && fields->size() == table_.columns.size())
        return fmt::format("its fields are separated by {}, those of the others by {}: use one separator in all rows",
                           nameOfMark(mark), nameOfMark(table_.separator));
    }
    return table_.separator == ',' && row.fields.size() > table_.columns.size()
               ? "put fields with a comma in quotes, or separate columns by semicolons where numbers have a decimal "
                 "comma"
               : "correct the row or remove it";
  }

  void takeDecimalCommas() {
    refuseThousands();
    for (CsvRow& row : table_.rows)
      for (auto& field : row.fields) field = withPoint(std::move(field));
  }

  /// Refuses a number such as "1.190" if another number has a decimal comma, and "1,190" if another has a decimal
  /// point: the mark may separate thousands.
  void refuseThousands() {
    const auto isAnywhere = [&](char mark) {
      return std::ranges::any_of(table_.rows, [&](const CsvRow& row) {
        return std::ranges::any_of(row.fields, [&](const std::string& field) { return hasDecimals(field, mark); });
      });
    };
    for (const auto& [decimal, other] : {std::pair{',', '.'}, std::pair{'.', ','}}) {
      if (!isAnywhere(decimal)) continue;
      for (const CsvRow& row : table_.rows)
        for (const auto& field : row.fields)
          if (isAmbiguous(field, other))
            return refuse(
                {"row",
                 fmt::format("the number \"{}\" may have a separator of thousands: other numbers have a decimal {}",
                             field, decimal == ',' ? "comma" : "point"),
                 "", "export the numbers without separators of thousands", row.line});
    }
  }

  const TableWords& words_;
  std::vector<TextLine> lines_, comments_;
  std::vector<std::string> of_units_;
  TextTable table_;
};

/// Splits the text into the parts before and inside its last pair of brackets; returns false if there is none.
bool splitBrackets(std::string_view text, std::string_view& before, std::string_view& inside) {
  const std::size_t open = text.find_last_of("([");
  const std::size_t close = text.find_last_of(")]");
  if (open == std::string_view::npos || close == std::string_view::npos || close < open) return false;
  before = text.substr(0, open);
  inside = text.substr(open + 1, close - open - 1);
  return true;
}

}  // namespace

TextTable parseTextTable(std::string_view text, const TableWords& words) { return TableParser(text, words).parse(); }

std::string plainName(std::string_view text) {
  std::string plain;
  for (char c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) > 127) plain += c;
  }
  return plain;
}

HeadingWords splitHeading(std::string_view text, bool (*isUnit)(std::string_view)) {
  std::string_view before, inside;
  if (splitBrackets(text, before, inside) && isUnit(inside))
    return {plainName(before), std::string(trimBlanks(inside))};
  text = trimBlanks(text);
  const std::size_t at = text.find_last_of(" _,/");
  if (at != std::string_view::npos && at > 0 && isUnit(text.substr(at + 1)))
    return {plainName(text.substr(0, at)), std::string(text.substr(at + 1))};
  return {plainName(text), ""};
}

std::string_view behindUnits(std::string_view line) {
  constexpr std::string_view kWord = "unit";
  const auto isSameLetter = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
  const auto isLetter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto word = std::ranges::search(line, kWord, isSameLetter);
  if (word.empty() || (word.begin() != line.begin() && isLetter(*std::prev(word.begin())))) return {};
  std::string_view following(word.end(), line.end());
  if (!following.empty() && isSameLetter(following.front(), 's')) following.remove_prefix(1);
  following = trimBlanks(following);
  return !following.empty() && (following.front() == ':' || following.front() == '=') ? following.substr(1)
                                                                                      : std::string_view();
}

std::string statedUnit(const std::vector<std::string>& lines_before, bool (*isUnit)(std::string_view)) {
  for (const std::string& line : lines_before)
    if (const std::string_view unit = trimBlanks(behindUnits(line)); isUnit(unit)) return std::string(unit);
  return "";
}

}  // namespace tubeplan::tubesheets
