// parseWorkListCsv.
#include <fmt/format.h>

#include <map>
#include <utility>

#include "tubesheets/csv_table.hpp"
#include "tubesheets/length_unit.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::tubesheets {
namespace {

const std::vector<std::string>& workListColumns() {
  static const std::vector<std::string> known{"row",  "column", "leg",      "sheet",   "sg",     "zone",
                                              "tool", "state",  "x_in",     "y_in",    "x_mm",   "y_mm",
                                              "x_m",  "y_m",    "priority", "comment", "dwell_s"};
  return known;
}

WorkList refusedList(Problem problem) { return {WorkListStatus::kRefused, std::move(problem), {}}; }

std::string fieldOf(const CsvTable& table, const CsvRow& row, std::string_view column) {
  const auto place = table.find(column);
  return place ? row.fields[*place] : "";
}

std::string describeLeg(const std::optional<Leg>& leg) { return leg ? std::string(legName(*leg)) : "no leg"; }
std::string describeSheet(const std::string& sheet) { return sheet.empty() ? "no sheet" : sheet; }

// A list is for one leg of one sheet; a line that says otherwise was pasted from another list.
std::optional<Problem> findOddLine(const WorkListItem& first, const WorkListItem& item) {
  if (item.leg != first.leg)
    return Problem{"leg", describeLeg(item.leg), describeLeg(first.leg) + ", as on the lines above",
                   "keep one list for each leg", item.line};
  if (item.sheet != first.sheet)
    return Problem{"sheet", describeSheet(item.sheet), describeSheet(first.sheet) + ", as on the lines above",
                   "keep one list for each sheet", item.line};
  if (item.steam_generator != first.steam_generator)
    return Problem{"sg", "\"" + item.steam_generator + "\"", "\"" + first.steam_generator + "\", as on the lines above",
                   "keep one list for each steam generator", item.line};
  return std::nullopt;
}

// The length in a column x_in, x_mm or x_m; not said where there is none or it is empty.
std::optional<Problem> readLength(const CsvTable& table, const CsvRow& row, const char* axis,
                                  std::optional<double>& metres) {
  for (const LengthUnit& unit : lengthUnits()) {
    const std::string column = fmt::format("{}_{}", axis, unit.suffix);
    const std::string field = fieldOf(table, row, column);
    if (field.empty()) continue;
    const auto number = parseNumber(field);
    if (!number) return Problem{column, "\"" + field + "\"", "a finite number", "", row.line};
    metres = *number * unit.metres;
  }
  return std::nullopt;
}

}  // namespace

WorkList parseWorkListCsv(std::string_view text) {
  const CsvTable table = parseCsvOfAnyCase(text);
  if (table.problem) return refusedList(*table.problem);
  if (const auto problem = findColumnProblem(table, workListColumns())) return refusedList(*problem);
  WorkList list{WorkListStatus::kRead, std::nullopt, {}};
  std::map<std::pair<int, int>, int> lines;
  for (const CsvRow& row : table.rows) {
    const TubeNumbers numbers = parseTubeNumbers(table, row);
    if (numbers.problem) return refusedList(*numbers.problem);
    const std::string leg = fieldOf(table, row, "leg");
    WorkListItem item{
        numbers.row, numbers.column,           row.line, findLeg(leg), fieldOf(table, row, "sheet"), {}, {}, {},
        {},          fieldOf(table, row, "sg")};
    if (auto problem = readLength(table, row, "x", item.x)) return refusedList(std::move(*problem));
    if (auto problem = readLength(table, row, "y", item.y)) return refusedList(std::move(*problem));
    if (const std::string dwell = fieldOf(table, row, "dwell_s"); !dwell.empty()) {
      item.dwell = parseNumber(dwell);
      if (!item.dwell || *item.dwell < 0 || *item.dwell > kLongestStay)
        return refusedList({"dwell_s", "\"" + dwell + "\"", "seconds from 0 to a day", "", row.line});
    }
    if (const std::string state = fieldOf(table, row, "state"); !state.empty()) {
      item.state = findTubeState(state);
      if (!item.state) return refusedList({"state", "\"" + state + "\"", "one of " + tubeStateNames(), "", row.line});
    }
    if (!leg.empty() && !item.leg) return refusedList({"leg", "\"" + leg + "\"", "one of " + legNames(), "", row.line});
    const auto [first, is_new] = lines.try_emplace({item.row, item.column}, item.line);
    if (!is_new)
      return refusedList({tubeName(item.row, item.column),
                          fmt::format("a second time (first on line {})", first->second), "every tube once",
                          "remove one of the lines", item.line});
    list.items.push_back(item);
    if (const auto problem = findOddLine(list.items.front(), item)) return refusedList(*problem);
  }
  if (list.items.empty())
    return refusedList({"text", "no tubes", "at least one line below the header", "", table.header_line});
  return list;
}

}  // namespace tubeplan::tubesheets
