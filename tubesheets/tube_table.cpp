#include "tubesheets/tube_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "tubesheets/tube_forms.hpp"

namespace tubeplan::tubesheets {
namespace {

bool isNothing(std::string_view field) { return field == "-" || field == "--"; }

Problem badNumber(const TubeTable& table, const CsvRow& row, TubeColumn column) {
  return {table.nameOf(column), "\"" + table.field(row, column) + "\"",
          fmt::format("a whole number from 1 to {}", kLargestTubeNumber), "", row.line};
}

class ColumnFinder {
 public:
  explicit ColumnFinder(TubeTable table) : table_(std::move(table)) {}

  TubeTable find() {
    const auto& columns = table_.text.columns;
    stated_ = statedUnit(table_.text.lines_before, isTubeUnit);
    for (std::size_t c = 0; c < columns.size() && !table_.problem; ++c) {
      if (columns[c].empty())
        refuse("header", fmt::format("column {} has no name", c + 1), "", "name every column");
      else if (std::ranges::find(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(c), columns[c]) !=
               columns.begin() + static_cast<std::ptrdiff_t>(c))
        refuse("header", "the column \"" + columns[c] + "\" occurs twice", "", "rename or remove one of them");
      else
        take(c);
    }
    return completed();
  }

  TubeTable choose(const std::vector<ChosenTubeColumn>& chosen) {
    stated_ = statedUnit(table_.text.lines_before, isTubeUnit);
    std::vector<std::string> unread = table_.text.columns;
    for (const auto& [column, place, unit] : chosen) {
      put(column, place, unit ? std::string(unit->suffix) : "");
      unread[place].clear();
    }
    std::ranges::copy_if(unread, std::back_inserter(table_.unread),
                         [](const std::string& name) { return !name.empty(); });
    return completed();
  }

 private:
  TubeTable completed() {
    requireTube();
    requireOneUnit();
    return std::move(table_);
  }

  void refuse(std::string what, std::string found, std::string expected, std::string advice) {
    if (!table_.problem)
      table_.problem =
          Problem{std::move(what), std::move(found), std::move(expected), std::move(advice), table_.text.heading_line};
  }

  void take(std::size_t c) {
    const std::string& heading = table_.text.columns[c];
    const TubeHeading parsed = readTubeHeading(heading);
    if (parsed.column) return put(*parsed.column, c, parsed.unit);
    if (const auto meant = tubeColumnMeantBy(heading))
      refuse("header", fmt::format("the column \"{}\" may be a misspelling of \"{}\"", heading, nameOf(*meant)), "",
             "rename or remove it");
    table_.unread.push_back(heading);
  }

  void put(TubeColumn column, std::size_t c, const std::string& unit) {
    if (column == TubeColumn::kNote) return;
    const bool is_code = column == TubeColumn::kState || column == TubeColumn::kCode;
    if (is_code) table_.codes.push_back({c, column == TubeColumn::kState});
    if (isPlaceColumn(column)) takeUnit(column, unit);
    const auto [first, is_new] = table_.places.emplace(column, c);
    if (is_new || is_code) return;
    if (isPlaceColumn(column))
      refuse("header", fmt::format("{} has columns in two units", nameOf(column)), "", "remove one of them");
    else
      refuse("header",
             fmt::format("\"{}\" and \"{}\" are both columns for {}", table_.text.columns[first->second],
                         table_.text.columns[c], nameOf(column)),
             "", "rename or remove one of them");
  }

  void takeUnit(TubeColumn axis, const std::string& unit) {
    const LengthUnit*& of_axis = axis == TubeColumn::kX ? table_.unit_x : table_.unit_y;
    of_axis = findLengthWord(unit.empty() ? stated_ : unit);
  }

  void requireTube() {
    if (table_.has(TubeColumn::kTube)) return;
    for (const auto& [column, name] : {std::pair{TubeColumn::kRow, "row"}, std::pair{TubeColumn::kColumn, "column"}})
      if (!table_.has(column))
        refuse("header", fmt::format("there is no column \"{}\" among {}", name, fmt::join(table_.text.columns, ", ")),
               "", "add the column to the header");
  }

  void requireOneUnit() {
    if (table_.unit_x && table_.unit_y && table_.unit_x->suffix != table_.unit_y->suffix)
      refuse("header",
             fmt::format("x and y have different units, {} and {}", table_.unit_x->suffix, table_.unit_y->suffix), "",
             "write both in the same unit");
  }

  TubeTable table_;
  std::string stated_;
};

}  // namespace

std::string TubeTable::field(const CsvRow& row, TubeColumn column) const {
  const auto place = places.find(column);
  if (place == places.end() || isNothing(row.fields[place->second])) return "";
  return row.fields[place->second];
}

std::string TubeTable::unreadText() const {
  if (unread.empty()) return "";
  return fmt::format("not used in planning, but kept: the column{} {}", unread.size() == 1 ? "" : "s",
                     fmt::join(unread, ", "));
}

TextTable parseTubeText(std::string_view text) {
  TextTable known = parseTextTable(text, {isTubeUnit, rankTubeHeading});
  if (!known.problem) return known;
  const auto isHeading = [](const std::vector<std::string>&) { return HeadingRank::kWhole; };
  for (const TableWords& words : {TableWords{isTubeUnit}, TableWords{isTubeUnit, isHeading}})
    if (TextTable other = parseTextTable(text, words); !other.problem) return other;
  return known;
}

TubeTable tubeTableOf(TextTable text, const std::vector<ChosenTubeColumn>& chosen) {
  TubeTable table;
  table.problem = text.problem;
  table.text = std::move(text);
  return table.problem ? table : ColumnFinder(std::move(table)).choose(chosen);
}

TubeTable parseTubeTable(std::string_view text) {
  TubeTable table;
  table.text = parseTextTable(text, {isTubeUnit, rankTubeHeading});
  table.problem = table.text.problem;
  return table.problem ? table : ColumnFinder(std::move(table)).find();
}

void TubeText::refuse(const std::optional<Problem>& other) {
  if (!problem) problem = other;
}

void TubeText::readRows(std::string_view what, const std::function<void(const CsvRow&)>& readRow) {
  refuse(table.problem);
  for (const CsvRow& row : table.text.rows) {
    if (problem) break;
    readRow(row);
  }
  if (table.text.rows.empty())
    refuse(Problem{"text", fmt::format("there are no {} below the header", what), "", "write a row for each",
                   table.text.heading_line});
  status = problem ? TubeTextStatus::kRefused : TubeTextStatus::kRead;
}

void TubeText::addNotes(const std::vector<std::string>& more) {
  if (problem) return;
  const auto add = [&](const std::string& note) {
    if (!note.empty()) notes.push_back(note);
  };
  add(table.unreadText());
  for (const std::string& note : more) add(note);
}

NamedTube tubeOf(const TubeTable& table, const CsvRow& row) {
  const std::string tube = table.field(row, TubeColumn::kTube);
  std::optional<RowAndColumn> named = tube.empty() ? std::nullopt : readTubeForm(tube);
  const std::optional<int> of_row = readRowNumber(table.field(row, TubeColumn::kRow));
  // In tables of once-through generators, the columns Row and Tube state the row and the number of the tube within it.
  const bool counts_tubes = table.has(TubeColumn::kRow) && !table.has(TubeColumn::kColumn) && !named;
  const std::optional<int> of_column =
      readColumnNumber(table.field(row, counts_tubes ? TubeColumn::kTube : TubeColumn::kColumn));
  if (!tube.empty() && !named && !counts_tubes)
    return {
        {},
        Problem{table.nameOf(TubeColumn::kTube), "\"" + tube + "\"", "a tube such as R12C34, R012C034, 12-34 or 12/34",
                "otherwise give row and column in columns of their own", row.line}};
  for (const auto& [column, number] : {std::pair{TubeColumn::kRow, of_row}, std::pair{TubeColumn::kColumn, of_column}})
    if (table.has(column) && !number && (!named || !table.field(row, column).empty()))
      return {{}, badNumber(table, row, column)};
  if (!named && !(of_row && of_column)) return {{}, badNumber(table, row, TubeColumn::kTube)};
  const RowAndColumn found = named.value_or(RowAndColumn{of_row.value_or(0), of_column.value_or(0)});
  if (of_row.value_or(found.row) != found.row || of_column.value_or(found.column) != found.column)
    return {{},
            Problem{table.nameOf(TubeColumn::kTube), "\"" + tube + "\"",
                    fmt::format("row {}, column {}, as in the columns beside it", of_row.value_or(found.row),
                                of_column.value_or(found.column)),
                    "correct one of them", row.line}};
  return {found, std::nullopt};
}

ReadLength lengthOf(const TubeTable& table, const CsvRow& row, TubeColumn axis) {
  const LengthUnit* unit = axis == TubeColumn::kX ? table.unit_x : table.unit_y;
  const std::string field = table.field(row, axis);
  if (!unit || field.empty()) return {};
  const auto number = parseNumber(field);
  if (!number) return {{}, Problem{table.nameOf(axis), "\"" + field + "\"", "a finite number", "", row.line}};
  return {*number * unit->metres, std::nullopt};
}

ReadCodes codesOf(const TubeTable& table, const CsvRow& row) {
  ReadCodes read;
  for (const auto& [place, is_state] : table.codes) {
    const std::string& field = row.fields[place];
    if (field.empty() || isNothing(field) || (!is_state && parseNumber(field))) continue;
    const TubeCode* code = findTubeCode(field);
    if (!code && is_state)
      read.problem = Problem{table.text.columns[place], "\"" + field + "\"", "one of " + tubeCodeNames(),
                             "write remarks in a column with another name", row.line};
    else if (!code)
      read.unknown.push_back(field);
    else if (code->use == CodeUse::kState && read.state && *read.state != code->state)
      read.problem = Problem{table.text.columns[place], "\"" + field + "\"",
                             fmt::format("{}, as in the column beside it", tubeStateName(*read.state)),
                             "keep the one that is right", row.line};
    else if (code->use == CodeUse::kState)
      read.state = code->state;
    else if (code->use == CodeUse::kDone)
      read.is_done = true;
    if (read.problem) break;
  }
  return read;
}

std::string unknownCodesText(const std::map<std::string, int>& counts) {
  constexpr std::size_t kShown = 8;
  std::vector<std::string> named;
  for (const auto& [code, count] : counts) {
    if (named.size() == kShown) break;
    named.push_back(count == 1 ? code : fmt::format("{} ({} rows)", code, count));
  }
  if (counts.size() > kShown) named.push_back(fmt::format("{} more", counts.size() - kShown));
  return named.empty() ? "" : fmt::format("unknown codes, treated as remarks: {}", fmt::join(named, ", "));
}

}  // namespace tubeplan::tubesheets
