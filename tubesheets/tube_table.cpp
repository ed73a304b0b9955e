#include "tubesheets/tube_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "tubesheets/tube_forms.hpp"

namespace tubeplan::tubesheets {
namespace {

struct ColumnNames {
  TubeColumn column;
  std::string_view name;                  ///< for messages
  std::vector<std::string_view> aliases;  ///< as plainName() gives them, without a unit
};

/// The open table of columns: one row each, with what they are called elsewhere.
const std::vector<ColumnNames>& columnTable() {
  static const std::vector<ColumnNames> table{
      {TubeColumn::kRow, "row", {"row", "r", "rowno", "rownumber"}},
      {TubeColumn::kColumn, "column", {"column", "col", "c", "colno", "columnno", "columnnumber", "line"}},
      {TubeColumn::kTube, "tube", {"tube", "tubeid", "tubename", "hole", "holeid", "holename"}},
      {TubeColumn::kX, "x", {"x", "xcoord", "xcoordinate", "xpos"}},
      {TubeColumn::kY, "y", {"y", "ycoord", "ycoordinate", "ypos"}},
      {TubeColumn::kLeg, "leg", {"leg"}},
      {TubeColumn::kSheet, "sheet", {"sheet"}},
      {TubeColumn::kSteamGenerator, "sg", {"sg", "steamgenerator"}},
      {TubeColumn::kState, "state", {"state", "status"}},
      {TubeColumn::kCode, "code", {"code", "ind", "indication"}},
      {TubeColumn::kDwell, "dwell_s", {"dwell"}},
      {TubeColumn::kVisit, "visit", {"visit"}},
      {TubeColumn::kOutcome, "outcome", {"outcome"}},
      {TubeColumn::kNote,
       "comment",
       {"comment", "comments", "remark", "remarks", "note", "notes", "zone", "tool", "priority"}},
  };
  return table;
}

constexpr std::array<std::string_view, 4> kSeconds{"s", "sec", "second", "seconds"};

bool isListUnit(std::string_view word) {
  const std::string_view unit = trimBlanks(word);
  return findLengthWord(unit) != nullptr || std::ranges::find(kSeconds, unit) != kSeconds.end();
}

bool isAxis(TubeColumn column) { return column == TubeColumn::kX || column == TubeColumn::kY; }

/// A unit of another kind makes a heading that of something else: "row (mm)" is no row.
const ColumnNames* columnCalled(const HeadingWords& heading) {
  for (const ColumnNames& row : columnTable()) {
    if (std::ranges::find(row.aliases, heading.name) == row.aliases.end()) continue;
    const bool is_length = findLengthWord(heading.unit) != nullptr;
    if (heading.unit.empty()) return row.column == TubeColumn::kDwell ? nullptr : &row;
    if (is_length ? isAxis(row.column) : row.column == TubeColumn::kDwell) return &row;
  }
  return nullptr;
}

const ColumnNames* columnCalled(const std::string& heading) { return columnCalled(splitHeading(heading, isListUnit)); }

HeadingRank rankTubeHeading(const std::vector<std::string>& fields) {
  bool has_row = false, has_column = false, has_tube = false;
  for (const std::string& field : fields) {
    const ColumnNames* found = columnCalled(field);
    if (!found) continue;
    has_row |= found->column == TubeColumn::kRow;
    has_column |= found->column == TubeColumn::kColumn;
    has_tube |= found->column == TubeColumn::kTube;
  }
  if (has_tube || (has_row && has_column)) return HeadingRank::kWhole;
  return has_row || has_column ? HeadingRank::kPartial : HeadingRank::kNone;
}

/// One letter more or less at the end: "legg", "stat". What was meant to be read is not left out.
const ColumnNames* columnAlmostCalled(const std::string& name) {
  constexpr std::size_t kLeast = 3;
  for (const ColumnNames& row : columnTable()) {
    if (row.column == TubeColumn::kNote) continue;
    for (const std::string_view alias : row.aliases) {
      const std::string_view shorter = name.size() < alias.size() ? std::string_view(name) : alias;
      const std::string_view longer = name.size() < alias.size() ? alias : std::string_view(name);
      if (shorter.size() >= kLeast && longer.size() == shorter.size() + 1 && longer.starts_with(shorter)) return &row;
    }
  }
  return nullptr;
}

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
    stated_ = statedUnit(table_.text.lines_before, isListUnit);
    for (std::size_t c = 0; c < columns.size() && !table_.problem; ++c) {
      if (columns[c].empty())
        refuse(fmt::format("header, column {}", c + 1), "no name", "a name for every column", "");
      else if (std::ranges::find(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(c), columns[c]) !=
               columns.begin() + static_cast<std::ptrdiff_t>(c))
        refuse("header", "the column \"" + columns[c] + "\" twice", "every column once", "rename or remove one");
      else
        take(c);
    }
    requireTube();
    requireOneUnit();
    return std::move(table_);
  }

 private:
  void refuse(std::string what, std::string found, std::string expected, std::string advice) {
    if (!table_.problem)
      table_.problem =
          Problem{std::move(what), std::move(found), std::move(expected), std::move(advice), table_.text.heading_line};
  }

  void take(std::size_t c) {
    const std::string& heading = table_.text.columns[c];
    const HeadingWords words = splitHeading(heading, isListUnit);
    const ColumnNames* found = columnCalled(words);
    if (!found) {
      if (const ColumnNames* meant = columnAlmostCalled(words.name))
        refuse("header", "the column \"" + heading + "\"", fmt::format("the name \"{}\", or another one", meant->name),
               "rename or remove it");
      table_.unread.push_back(heading);
      return;
    }
    if (found->column == TubeColumn::kNote) return;
    const bool is_code = found->column == TubeColumn::kState || found->column == TubeColumn::kCode;
    if (is_code) table_.codes.push_back({c, found->column == TubeColumn::kState});
    if (isAxis(found->column)) takeUnit(found->column, words.unit);
    const auto [first, is_new] = table_.places.emplace(found->column, c);
    if (is_new || is_code) return;
    const std::string& other = table_.text.columns[first->second];
    if (isAxis(found->column))
      refuse("header", fmt::format("{} in two units", found->name), "one unit", "remove one column");
    else
      refuse("header", fmt::format("\"{}\" and \"{}\", both for {}", other, heading, found->name), "one of them",
             "rename or remove the other");
  }

  void takeUnit(TubeColumn axis, const std::string& unit) {
    const LengthUnit*& of_axis = axis == TubeColumn::kX ? table_.unit_x : table_.unit_y;
    of_axis = findLengthWord(unit.empty() ? stated_ : unit);
  }

  void requireTube() {
    if (table_.has(TubeColumn::kTube)) return;
    for (const auto& [column, name] : {std::pair{TubeColumn::kRow, "row"}, std::pair{TubeColumn::kColumn, "column"}})
      if (!table_.has(column))
        refuse("header", fmt::format("columns {}", fmt::join(table_.text.columns, ", ")),
               fmt::format("a column \"{}\"", name), "add it to the header");
  }

  void requireOneUnit() {
    if (table_.unit_x && table_.unit_y && table_.unit_x->suffix != table_.unit_y->suffix)
      refuse("header", fmt::format("x in {} and y in {}", table_.unit_x->suffix, table_.unit_y->suffix),
             "both in one unit", "");
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
  return fmt::format("left out of planning, and kept: the column{} {}", unread.size() == 1 ? "" : "s",
                     fmt::join(unread, ", "));
}

TubeTable parseTubeTable(std::string_view text) {
  TubeTable table;
  table.text = parseTextTable(text, {isListUnit, rankTubeHeading});
  table.problem = table.text.problem;
  return table.problem ? table : ColumnFinder(std::move(table)).find();
}

NamedTube tubeOf(const TubeTable& table, const CsvRow& row) {
  const std::string tube = table.field(row, TubeColumn::kTube);
  std::optional<RowAndColumn> named = tube.empty() ? std::nullopt : readTubeForm(tube);
  const std::optional<int> of_row = readRowNumber(table.field(row, TubeColumn::kRow));
  // Of once-through generators tubes are counted in their row: Row and Tube.
  const bool counts_tubes = table.has(TubeColumn::kRow) && !table.has(TubeColumn::kColumn) && !named;
  const std::optional<int> of_column =
      readColumnNumber(table.field(row, counts_tubes ? TubeColumn::kTube : TubeColumn::kColumn));
  if (!tube.empty() && !named && !counts_tubes)
    return {
        {},
        Problem{table.nameOf(TubeColumn::kTube), "\"" + tube + "\"", "a tube such as R12C34, R012C034, 12-34 or 12/34",
                "or give row and column in columns of their own", row.line}};
  for (const auto& [column, number] : {std::pair{TubeColumn::kRow, of_row}, std::pair{TubeColumn::kColumn, of_column}})
    if (table.has(column) && !number && (!named || !table.field(row, column).empty()))
      return {{}, badNumber(table, row, column)};
  if (!named && !(of_row && of_column)) return {{}, badNumber(table, row, TubeColumn::kTube)};
  const RowAndColumn found = named.value_or(RowAndColumn{of_row.value_or(0), of_column.value_or(0)});
  if (of_row.value_or(found.row) != found.row || of_column.value_or(found.column) != found.column)
    return {{},
            Problem{table.nameOf(TubeColumn::kTube), "\"" + tube + "\"",
                    fmt::format("row {}, column {}, as beside it", of_row.value_or(found.row),
                                of_column.value_or(found.column)),
                    "correct the one or the other", row.line}};
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
                             "write remarks into a column of another name", row.line};
    else if (!code)
      read.unknown.push_back(field);
    else if (code->use == CodeUse::kState && read.state && *read.state != code->state)
      read.problem =
          Problem{table.text.columns[place], "\"" + field + "\"",
                  fmt::format("{}, as beside it", tubeStateName(*read.state)), "keep the one that is true", row.line};
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
  return named.empty() ? "" : fmt::format("codes that are not known, taken as remarks: {}", fmt::join(named, ", "));
}

}  // namespace tubeplan::tubesheets
