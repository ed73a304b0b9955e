#include "tubesheets/hole_map_csv.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "tubesheets/table_text.hpp"

namespace tubeplan::tubesheets {
namespace {

// Reads rows into a map, and stops at the first fault.
class MapReader {
 public:
  explicit MapReader(std::string_view text) {
    map_.text = text;
    map_.table = parseTubeTable(text);
  }

  HoleMap read() {
    map_.refuse(map_.table.problem);
    requirePlaces();
    map_.readRows("holes", [this](const CsvRow& row) { readRow(row); });
    if (map_.problem) map_.tubes.clear();
    map_.addNotes({unknownCodesText(unknown_)});
    return std::move(map_);
  }

 private:
  void requirePlaces() {
    for (const auto& [axis, name, unit] :
         {std::tuple{TubeColumn::kX, 'x', map_.table.unit_x}, std::tuple{TubeColumn::kY, 'y', map_.table.unit_y}})
      if (!unit)
        map_.refuse(Problem{
            "header", fmt::format("there is no {} for {}", map_.table.has(axis) ? "unit" : "column", name), "",
            fmt::format("name the column with its unit: {0}_in, {0}_mm or {0}_m", name), map_.table.text.heading_line});
  }

  void readRow(const CsvRow& row) {
    const NamedTube named = tubeOf(map_.table, row);
    map_.refuse(named.problem);
    Tube tube{named.tube.row, named.tube.column};
    tube.x = readPlace(row, TubeColumn::kX);
    tube.y = readPlace(row, TubeColumn::kY);
    const ReadCodes codes = codesOf(map_.table, row);
    map_.refuse(codes.problem);
    tube.state = codes.state.value_or(TubeState::kOpen);
    for (const std::string& code : codes.unknown) ++unknown_[code];
    readLeg(row);
    const auto [first, is_new] = lines_.try_emplace({tube.row, tube.column}, row.line);
    if (!is_new)
      map_.refuse(Problem{tubeName(tube.row, tube.column),
                          fmt::format("the tube occurs a second time (first on line {})", first->second), "",
                          "remove one of the lines", row.line});
    map_.tubes.push_back(tube);
  }

  double readPlace(const CsvRow& row, TubeColumn axis) {
    const ReadLength length = lengthOf(map_.table, row, axis);
    map_.refuse(length.problem);
    if (!length.metres) map_.refuse(Problem{map_.table.nameOf(axis), "\"\"", "a finite number", "", row.line});
    return snapLength(length.metres.value_or(0));
  }

  void readLeg(const CsvRow& row) {
    if (!map_.table.has(TubeColumn::kLeg)) return;
    const std::string field = map_.table.field(row, TubeColumn::kLeg);
    const auto leg = findLeg(field);
    if (!leg) map_.refuse(Problem{"leg", "\"" + field + "\"", "one of " + legNames(), "", row.line});
    if (leg && map_.leg && *leg != *map_.leg)
      map_.refuse(Problem{"leg", std::string(legName(*leg)),
                          fmt::format("{}, as on the lines above", legName(*map_.leg)), "keep one map for each leg",
                          row.line});
    if (!map_.leg) map_.leg = leg;
  }

  HoleMap map_;
  std::map<std::pair<int, int>, int> lines_;  // line where each tube (row, column) first occurs
  std::map<std::string, int> unknown_;        // unknown codes with their counts
};

std::string ownHeading(const LengthUnit& unit) { return fmt::format("row,column,x_{0},y_{0},state", unit.suffix); }

std::string ownRow(const Tube& tube, const LengthUnit& unit) {
  return fmt::format("{},{},{},{},{}", tube.row, tube.column, formatLength(tube.x, unit), formatLength(tube.y, unit),
                     tubeStateName(tube.state));
}

/// Returns the index of the state column if the table has commas and all the columns of ownHeading() under exactly
/// these names; otherwise nothing.
std::optional<std::size_t> placeOfStateInOwn(const HoleMap& map, const LengthUnit& unit) {
  const TextTable& table = map.table.text;
  std::string heading = ownHeading(unit);
  const auto names = splitCsvLine(heading, ',');
  if (table.separator != ',' || table.units_line != 0) return std::nullopt;
  for (const std::string& name : *names)
    if (std::ranges::find(table.columns, name) == table.columns.end()) return std::nullopt;
  return static_cast<std::size_t>(std::ranges::find(table.columns, names->back()) - table.columns.begin());
}

/// Returns the text of the map as it was read, with the fields of its state column replaced by the tubes' states.
std::string ownText(const Sheet& sheet, std::size_t place) {
  const HoleMap& map = *sheet.map;
  ColumnText state{"state", place, {}};
  for (std::size_t k = 0; k < map.tubes.size(); ++k) {
    const CsvRow& row = map.table.text.rows[k];
    const Tube* tube = sheet.find(map.tubes[k].row, map.tubes[k].column);
    const bool says_nothing = row.fields[place].empty() && tube->state == TubeState::kOpen;
    if (!says_nothing) state.fields.emplace(row.line, tubeStateName(tube->state));
  }
  return withColumns(map.text, map.table.text, {state});
}

/// Returns the indices of the columns that hold neither row, column, tube name, x, y nor state.
std::vector<std::size_t> otherColumns(const TubeTable& table) {
  std::vector<std::size_t> others;
  for (std::size_t c = 0; c < table.text.columns.size(); ++c) {
    const auto isAt = [&](TubeColumn column) { return table.has(column) && table.places.at(column) == c; };
    const bool is_own = isAt(TubeColumn::kRow) || isAt(TubeColumn::kColumn) || isAt(TubeColumn::kTube) ||
                        isAt(TubeColumn::kX) || isAt(TubeColumn::kY) || isAt(TubeColumn::kState);
    if (!is_own) others.push_back(c);
  }
  return others;
}

/// Returns the map under ownHeading(), with the lines before its table as comments and its other columns last.
std::string convertedText(const Sheet& sheet, const LengthUnit& unit) {
  const TextTable* table = sheet.map ? &sheet.map->table.text : nullptr;
  const std::vector<std::size_t> others = table ? otherColumns(sheet.map->table) : std::vector<std::size_t>{};
  std::map<std::pair<int, int>, const CsvRow*> rows;
  std::string text;
  for (std::size_t k = 0; table && k < table->rows.size(); ++k)
    rows[{sheet.map->tubes[k].row, sheet.map->tubes[k].column}] = &table->rows[k];
  if (table)
    for (const std::string& line : table->lines_before) text += (line.starts_with('#') ? "" : "# ") + line + "\n";
  text += ownHeading(unit);
  for (const std::size_t c : others) text += "," + csvField(table->columns[c]);
  text += "\n";
  for (const Tube& tube : sheet.tubes) {
    text += ownRow(tube, unit);
    for (const std::size_t c : others) text += "," + csvField(rows.at({tube.row, tube.column})->fields[c]);
    text += "\n";
  }
  return text;
}

}  // namespace

std::string formatHoleMap(const Sheet& sheet, const LengthUnit& unit) {
  const auto place = sheet.map ? placeOfStateInOwn(*sheet.map, unit) : std::nullopt;
  return place ? ownText(sheet, *place) : convertedText(sheet, unit);
}

HoleMap parseHoleMap(std::string_view text) { return MapReader(text).read(); }

}  // namespace tubeplan::tubesheets
