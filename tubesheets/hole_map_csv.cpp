#include "tubesheets/hole_map_csv.hpp"

#include <fmt/format.h>

#include <iterator>
#include <map>
#include <utility>
#include <variant>

#include "tubesheets/csv_table.hpp"

namespace tubeplan::tubesheets {
namespace {

struct Axis {
  std::size_t column = 0;
  LengthUnit unit{"", 0};
};

std::vector<std::string> holeMapColumns() {
  std::vector<std::string> known{"row", "column"};
  for (const char axis : {'x', 'y'})
    for (const LengthUnit& unit : lengthUnits()) known.push_back(fmt::format("{}_{}", axis, unit.suffix));
  known.insert(known.end(), {"state", "leg", "comment"});
  return known;
}

// The one column of that axis, whichever unit it is in.
std::variant<Axis, Problem> findAxis(const CsvTable& table, char axis) {
  std::optional<Axis> found;
  for (const LengthUnit& unit : lengthUnits()) {
    const auto column = table.find(fmt::format("{}_{}", axis, unit.suffix));
    if (column && found)
      return Problem{"header", fmt::format("{} in two units", axis), "one unit", "remove one column",
                     table.header_line};
    if (column) found = Axis{*column, unit};
  }
  if (found) return *found;
  return Problem{"header", fmt::format("no column for {}", axis), fmt::format("{0}_in, {0}_mm or {0}_m", axis),
                 "name the unit in the column's name", table.header_line};
}

// Reads rows into a map, stopping at the first fault.
class Reader {
 public:
  Reader(const CsvTable& table, const Axis& x, const Axis& y) : table_(table), x_(x), y_(y) {}

  HoleMap read() {
    for (const CsvRow& row : table_.rows) {
      readRow(row);
      if (map_.problem) break;
    }
    if (!map_.problem && map_.tubes.empty())
      map_.problem = Problem{"text", "no holes", "at least one line below the header", "", table_.header_line};
    map_.status = map_.problem ? HoleMapStatus::kRefused : HoleMapStatus::kRead;
    if (map_.problem) map_.tubes.clear();
    return std::move(map_);
  }

 private:
  void readRow(const CsvRow& row) {
    const TubeNumbers numbers = parseTubeNumbers(table_, row);
    if (numbers.problem) map_.problem = numbers.problem;
    Tube tube{numbers.row, numbers.column};
    readLength(row, x_, tube.x);
    readLength(row, y_, tube.y);
    readState(row, tube);
    readLeg(row);
    const auto [first, is_new] = lines_.try_emplace({tube.row, tube.column}, row.line);
    if (!is_new)
      refuse(row, tubeName(tube.row, tube.column), fmt::format("a second time (first on line {})", first->second),
             "every tube once", "remove one of the lines");
    map_.tubes.push_back(tube);
  }

  void readLength(const CsvRow& row, const Axis& axis, double& length) {
    const std::string& field = row.fields[axis.column];
    const std::optional<double> number = parseNumber(field);
    if (!number) refuse(row, table_.columns[axis.column], "\"" + field + "\"", "a finite number", "");
    length = snapLength(number.value_or(0) * axis.unit.metres);
  }

  void readState(const CsvRow& row, Tube& tube) {
    const auto column = table_.find("state");
    if (!column || row.fields[*column].empty()) return;
    const auto state = findTubeState(row.fields[*column]);
    if (!state) refuse(row, "state", "\"" + row.fields[*column] + "\"", "one of " + tubeStateNames(), "");
    tube.state = state.value_or(TubeState::kUnresolved);
  }

  void readLeg(const CsvRow& row) {
    const auto column = table_.find("leg");
    if (!column) return;
    const auto leg = findLeg(row.fields[*column]);
    if (!leg) refuse(row, "leg", "\"" + row.fields[*column] + "\"", "one of " + legNames(), "");
    if (leg && map_.leg && *leg != *map_.leg)
      refuse(row, "leg", std::string(legName(*leg)), fmt::format("{}, as on the lines above", legName(*map_.leg)),
             "keep one map for each leg");
    if (!map_.leg) map_.leg = leg;
  }

  void refuse(const CsvRow& row, std::string what, std::string found, std::string expected, std::string advice) {
    if (map_.problem) return;
    map_.problem = Problem{std::move(what), std::move(found), std::move(expected), std::move(advice), row.line};
  }

  const CsvTable& table_;
  Axis x_, y_;
  HoleMap map_;
  std::map<std::pair<int, int>, int> lines_;  // where each tube was first named
};

HoleMap refusedMap(Problem problem) {
  HoleMap map;
  map.status = HoleMapStatus::kRefused;
  map.problem = std::move(problem);
  return map;
}

}  // namespace

std::string formatHoleMap(const Sheet& sheet, const LengthUnit& unit) {
  std::string text = fmt::format("row,column,x_{0},y_{0},state\n", unit.suffix);
  for (const Tube& tube : sheet.tubes)
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{}\n", tube.row, tube.column, formatLength(tube.x, unit),
                   formatLength(tube.y, unit), tubeStateName(tube.state));
  return text;
}

HoleMap parseHoleMap(std::string_view text) {
  const CsvTable table = parseCsvOfAnyCase(text);
  if (table.problem) return refusedMap(*table.problem);
  const auto x = findAxis(table, 'x'), y = findAxis(table, 'y');
  for (const auto* axis : {&x, &y})
    if (const auto* problem = std::get_if<Problem>(axis)) return refusedMap(*problem);
  if (const auto problem = findColumnProblem(table, holeMapColumns())) return refusedMap(*problem);
  const LengthUnit unit_x = std::get<Axis>(x).unit, unit_y = std::get<Axis>(y).unit;
  if (unit_x.suffix != unit_y.suffix)
    return refusedMap({"header", fmt::format("x in {} and y in {}", unit_x.suffix, unit_y.suffix), "both in one unit",
                       "", table.header_line});
  return Reader(table, std::get<Axis>(x), std::get<Axis>(y)).read();
}

}  // namespace tubeplan::tubesheets
