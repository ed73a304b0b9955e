#include "app/files/foreign/foreign_heading.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "app/files/lower_case.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

struct UnitWord {
  std::string_view word;
  UnitKind kind;
  std::string_view name;
};

/// Beside the program's own names of units.
constexpr UnitWord kUnitWords[] = {
    {"millimeter", UnitKind::kLength, "mm"},
    {"millimeters", UnitKind::kLength, "mm"},
    {"millimetre", UnitKind::kLength, "mm"},
    {"millimetres", UnitKind::kLength, "mm"},
    {"inch", UnitKind::kLength, "in"},
    {"inches", UnitKind::kLength, "in"},
    {"meter", UnitKind::kLength, "m"},
    {"meters", UnitKind::kLength, "m"},
    {"metre", UnitKind::kLength, "m"},
    {"metres", UnitKind::kLength, "m"},
    {"centimeters", UnitKind::kLength, "cm"},
    {"centimetres", UnitKind::kLength, "cm"},
    {"feet", UnitKind::kLength, "ft"},
    {"foot", UnitKind::kLength, "ft"},
    {"°", UnitKind::kAngle, "deg"},
    {"degree", UnitKind::kAngle, "deg"},
    {"degrees", UnitKind::kAngle, "deg"},
    {"radian", UnitKind::kAngle, "rad"},
    {"radians", UnitKind::kAngle, "rad"},
    {"lb", UnitKind::kForce, "lbf"},
    {"lbs", UnitKind::kForce, "lbf"},
    {"kg", UnitKind::kForce, "kgf"},
    {"kp", UnitKind::kForce, "kgf"},
    {"newton", UnitKind::kForce, "N"},
    {"newtons", UnitKind::kForce, "N"},
    {"°c", UnitKind::kTemperature, "degC"},
    {"°f", UnitKind::kTemperature, "degF"},
    {"celsius", UnitKind::kTemperature, "degC"},
    {"fahrenheit", UnitKind::kTemperature, "degF"},
    {"sec", UnitKind::kTime, "s"},
    {"seconds", UnitKind::kTime, "s"},
    {"minutes", UnitKind::kTime, "min"},
    {"hours", UnitKind::kTime, "h"},
};

/// Of surveyors' instruments alone: files of the program have none.
constexpr Unit kGon{UnitKind::kAngle, "gon", std::numbers::pi / 200};

constexpr std::array<std::string_view, 9> kCountWords{"pulse",   "pulses", "pls",        "count",    "counts",
                                                      "counter", "cts",    "increments", "increment"};

bool isCountWord(std::string_view word) {
  return std::ranges::find(kCountWords, lowerCase(tubesheets::trimBlanks(word))) != kCountWords.end();
}

/// Letters and digits of ASCII, and whatever is beyond it.
std::string plainName(std::string_view text) {
  std::string plain;
  for (const char c : lowerCase(text))
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) > 127) plain += c;
  return plain;
}

/// The text in the last brackets and what stands before them; nothing where there are none.
bool splitBrackets(std::string_view text, std::string_view& before, std::string_view& inside) {
  const std::size_t open = text.find_last_of("([");
  const std::size_t close = text.find_last_of(")]");
  if (open == std::string_view::npos || close == std::string_view::npos || close < open) return false;
  before = text.substr(0, open);
  inside = text.substr(open + 1, close - open - 1);
  return true;
}

}  // namespace

const Unit* findUnitWord(std::string_view word) {
  const std::string_view trimmed = tubesheets::trimBlanks(word);
  for (const Unit& unit : unitTable())
    if (unit.name == trimmed) return &unit;
  const std::string small = lowerCase(trimmed);
  for (const Unit& unit : unitTable())
    if (lowerCase(unit.name) == small) return &unit;
  for (const UnitWord& known : kUnitWords)
    if (known.word == small) return findUnit(known.kind, known.name);
  return small == kGon.name || small == "grad" || small == "gons" ? &kGon : nullptr;
}

OwnUnit ownUnitOf(const Unit& unit) {
  if (&unit != &kGon) return {&unit, 1};
  return {findUnit(UnitKind::kAngle, "deg"), 0.9};
}

std::vector<std::string> foreignUnitNames(UnitKind kind) {
  auto names = unitNames(kind);
  if (kind == kGon.kind) names.emplace_back(kGon.name);
  return names;
}

ForeignHeading parseHeading(std::string_view text) {
  std::string_view before, inside;
  if (splitBrackets(text, before, inside)) {
    if (const Unit* unit = findUnitWord(inside)) return {plainName(before), unit};
    if (isCountWord(inside)) return {plainName(before), nullptr, true};
  }
  text = tubesheets::trimBlanks(text);
  const std::size_t at = text.find_last_of(" _,/");
  if (at != std::string_view::npos && at > 0) {
    if (const Unit* unit = findUnitWord(text.substr(at + 1))) return {plainName(text.substr(0, at)), unit};
    if (isCountWord(text.substr(at + 1))) return {plainName(text.substr(0, at)), nullptr, true};
  }
  return {plainName(text), nullptr};
}

}  // namespace tubeplan::app
