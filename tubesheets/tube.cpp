#include "tubesheets/tube.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <vector>

#include "tubesheets/csv_table.hpp"
#include "tubesheets/text_table.hpp"

namespace tubeplan::tubesheets {
namespace {

template <class Value>
struct Named {
  Value value;
  std::string_view name;
  std::string_view words;  ///< description for reports; empty if the name is only an alias
};
// Clang 16 does not deduce the template arguments without this guide.
template <class Value>
Named(Value, std::string_view, std::string_view) -> Named<Value>;

constexpr std::array kLegs{Named{Leg::kHot, std::string_view("hot"), std::string_view("hot leg")},
                           Named{Leg::kCold, std::string_view("cold"), std::string_view("cold leg")},
                           Named{Leg::kFull, std::string_view("full"), std::string_view("full sheet")}};
constexpr std::array kShortLegs{Named{Leg::kHot, std::string_view("hl"), std::string_view()},
                                Named{Leg::kHot, std::string_view("h"), std::string_view()},
                                Named{Leg::kHot, std::string_view("hotleg"), std::string_view()},
                                Named{Leg::kHot, std::string_view("inlet"), std::string_view()},
                                Named{Leg::kCold, std::string_view("outlet"), std::string_view()},
                                Named{Leg::kCold, std::string_view("cl"), std::string_view()},
                                Named{Leg::kCold, std::string_view("c"), std::string_view()},
                                Named{Leg::kCold, std::string_view("coldleg"), std::string_view()}};
constexpr std::array kSides{Named{ViewedFrom::kBelow, std::string_view("below"), std::string_view("seen from below")},
                            Named{ViewedFrom::kAbove, std::string_view("above"), std::string_view("seen from above")}};
constexpr std::array kStates{
    Named{TubeState::kOpen, std::string_view("open"), std::string_view("open")},
    Named{TubeState::kPlugged, std::string_view("plugged"), std::string_view("plugged")},
    Named{TubeState::kSleeved, std::string_view("sleeved"), std::string_view("sleeved")},
    Named{TubeState::kStabilised, std::string_view("stabilised"), std::string_view("plugged and stabilised")},
    Named{TubeState::kToPlug, std::string_view("to-plug"), std::string_view("recommended to plug")},
    Named{TubeState::kInaccessible, std::string_view("inaccessible"), std::string_view("reported inaccessible")},
    Named{TubeState::kUnresolved, std::string_view("unresolved"), std::string_view("identity unresolved")}};

template <class Table, class Value>
std::string_view nameOf(const Table& table, Value value) {
  const auto row = std::find_if(table.begin(), table.end(), [&](const auto& r) { return r.value == value; });
  return row == table.end() ? "" : row->name;
}

template <class Table, class Value>
std::string_view wordsOf(const Table& table, Value value) {
  const auto row = std::find_if(table.begin(), table.end(), [&](const auto& r) { return r.value == value; });
  return row == table.end() ? "" : row->words;
}

template <class Table>
auto valueOf(const Table& table, std::string_view name) -> std::optional<decltype(table.front().value)> {
  const auto row = std::find_if(table.begin(), table.end(), [&](const auto& r) { return r.name == name; });
  if (row == table.end()) return std::nullopt;
  return row->value;
}

template <class Table>
auto listValues(const Table& table) {
  std::vector<decltype(table.front().value)> values;
  for (const auto& row : table) values.push_back(row.value);
  return values;
}

template <class Table>
std::string listNames(const Table& table) {
  std::vector<std::string_view> names;
  for (const auto& row : table) names.push_back(row.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::string tubeName(int row, int column) { return fmt::format("R{}C{}", row, column); }

std::optional<RowAndColumn> parseTubeName(std::string_view name) {
  const std::size_t c = name.find('C');
  if (!name.starts_with('R') || c == std::string_view::npos) return std::nullopt;
  const auto row = parseInteger(name.substr(1, c - 1));
  const auto column = parseInteger(name.substr(c + 1));
  if (!row || !column) return std::nullopt;
  return RowAndColumn{*row, *column};
}

std::string_view legName(Leg leg) { return nameOf(kLegs, leg); }
std::string_view viewedFromName(ViewedFrom side) { return nameOf(kSides, side); }
std::string_view tubeStateName(TubeState state) { return nameOf(kStates, state); }

std::string_view legWords(Leg leg) { return wordsOf(kLegs, leg); }
std::string_view viewedFromWords(ViewedFrom side) { return wordsOf(kSides, side); }
std::string_view tubeStateWords(TubeState state) { return wordsOf(kStates, state); }

std::vector<Leg> legs() { return listValues(kLegs); }
std::vector<TubeState> tubeStates() { return listValues(kStates); }

std::optional<Leg> findLeg(std::string_view name) {
  const std::string plain = plainName(name);
  const auto leg = valueOf(kLegs, plain);
  return leg ? leg : valueOf(kShortLegs, plain);
}
std::optional<ViewedFrom> findViewedFrom(std::string_view name) { return valueOf(kSides, name); }
std::optional<TubeState> findTubeState(std::string_view name) { return valueOf(kStates, name); }

std::string legNames() { return listNames(kLegs); }
std::string viewedFromNames() { return listNames(kSides); }
std::string tubeStateNames() { return listNames(kStates); }

}  // namespace tubeplan::tubesheets
