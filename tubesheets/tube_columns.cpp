#include "tubesheets/tube_columns.hpp"

#include <algorithm>
#include <array>

#include "tubesheets/length_unit.hpp"

namespace tubeplan::tubesheets {
namespace {

struct ColumnNames {
  TubeColumn column;
  std::string_view name;                  ///< name of the column in messages
  std::vector<std::string_view> aliases;  ///< all names in the form of plainName(), without a unit
};

/// Returns the table of known columns, one row for each column, with all its names.
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

bool isWrittenByPlans(TubeColumn column) { return column == TubeColumn::kVisit || column == TubeColumn::kOutcome; }

const ColumnNames* columnCalled(const HeadingWords& heading) {
  for (const ColumnNames& row : columnTable()) {
    if (std::ranges::find(row.aliases, heading.name) == row.aliases.end()) continue;
    const bool is_length = findLengthWord(heading.unit) != nullptr;
    if (heading.unit.empty()) return row.column == TubeColumn::kDwell ? nullptr : &row;
    if (is_length ? isPlaceColumn(row.column) : row.column == TubeColumn::kDwell) return &row;
  }
  return nullptr;
}

}  // namespace

std::string_view nameOf(TubeColumn column) {
  return std::ranges::find(columnTable(), column, &ColumnNames::column)->name;
}

bool isTubeUnit(std::string_view word) {
  const std::string_view unit = trimBlanks(word);
  return findLengthWord(unit) != nullptr || std::ranges::find(kSeconds, unit) != kSeconds.end();
}

TubeHeading readTubeHeading(const std::string& heading) {
  const HeadingWords words = splitHeading(heading, isTubeUnit);
  const ColumnNames* found = columnCalled(words);
  return {found ? std::optional(found->column) : std::nullopt, words.unit};
}

std::optional<TubeColumn> tubeColumnMeantBy(const std::string& heading) {
  const std::string name = splitHeading(heading, isTubeUnit).name;
  constexpr std::size_t kLeast = 3;
  for (const ColumnNames& row : columnTable()) {
    if (row.column == TubeColumn::kNote) continue;
    for (const std::string_view alias : row.aliases) {
      const std::string_view shorter = name.size() < alias.size() ? std::string_view(name) : alias;
      const std::string_view longer = name.size() < alias.size() ? alias : std::string_view(name);
      if (shorter.size() >= kLeast && longer.size() == shorter.size() + 1 && longer.starts_with(shorter))
        return row.column;
    }
  }
  return std::nullopt;
}

HeadingRank rankTubeHeading(const std::vector<std::string>& fields) {
  bool has_row = false, has_column = false, has_tube = false;
  for (const std::string& field : fields) {
    const auto column = readTubeHeading(field).column;
    has_row |= column == TubeColumn::kRow;
    has_column |= column == TubeColumn::kColumn;
    has_tube |= column == TubeColumn::kTube;
  }
  if (has_tube || (has_row && has_column)) return HeadingRank::kWhole;
  return has_row || has_column ? HeadingRank::kPartial : HeadingRank::kNone;
}

std::vector<TubeQuantity> tubeQuantities() {
  std::vector<TubeQuantity> quantities;
  for (const ColumnNames& row : columnTable()) {
    if (isWrittenByPlans(row.column) || row.column == TubeColumn::kNote) continue;
    TubeQuantity quantity{row.column, row.name, {}};
    if (row.column == TubeColumn::kDwell) quantity = {row.column, row.aliases.front(), {kSeconds.front()}};
    if (isPlaceColumn(row.column))
      for (const LengthUnit& unit : lengthUnits()) quantity.units.push_back(unit.suffix);
    quantities.push_back(std::move(quantity));
  }
  return quantities;
}

}  // namespace tubeplan::tubesheets
