#include "app/formats/foreign/foreign_heading.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "app/formats/foreign/sexagesimal.hpp"
#include "app/storage/lower_case.hpp"
#include "tubesheets/length_unit.hpp"
#include "tubesheets/text_table.hpp"

namespace tubeplan::app {

namespace {

struct UnitWord {
  std::string_view word;
  UnitKind kind;
  std::string_view name;
};

/// Words for units that foreign tables use in addition to the names in Tubeplan's files.
constexpr UnitWord kUnitWords[] = {
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

/// Units of angle that only surveyors and telescopes use. Tubeplan's files have degrees instead; each of these units is
/// a fixed number of degrees.
constexpr double kOneDegree = std::numbers::pi / 180;
constexpr Unit kForeignAngles[] = {{UnitKind::kAngle, "gon", 0.9 * kOneDegree},
                                   {UnitKind::kAngle, "h", kDegreesPerHour* kOneDegree},
                                   {UnitKind::kAngle, "hms", kDegreesPerHour* kOneDegree},
                                   {UnitKind::kAngle, "dms", kOneDegree}};

const Unit* foreignAngle(std::string_view name) {
  const auto found = std::ranges::find(kForeignAngles, name, &Unit::name);
  return found == std::end(kForeignAngles) ? nullptr : found;
}

constexpr std::array<std::string_view, 9> kCountWords{"pulse",   "pulses", "pls",        "count",    "counts",
                                                      "counter", "cts",    "increments", "increment"};

bool isCountWord(std::string_view word) {
  return std::ranges::find(kCountWords, lowerCase(tubesheets::trimBlanks(word))) != kCountWords.end();
}

}  // namespace

const Unit* findUnitWord(std::string_view word) {
  const std::string_view trimmed = tubesheets::trimBlanks(word);
  for (const Unit& unit : unitTable())
    if (unit.name == trimmed) return &unit;
  const std::string small = lowerCase(trimmed);
  for (const Unit& unit : unitTable())
    if (lowerCase(unit.name) == small) return &unit;
  if (const auto* length = tubesheets::findLengthWord(small)) return findUnit(UnitKind::kLength, length->suffix);
  for (const UnitWord& known : kUnitWords)
    if (known.word == small) return findUnit(known.kind, known.name);
  return foreignAngle(small == "grad" || small == "gons" ? "gon" : std::string_view(small));
}

const Unit* unitOfKind(const Unit* unit, UnitKind kind) {
  if (!unit || unit->kind == kind) return unit;
  const bool are_hours = kind == UnitKind::kAngle && unit == findUnit(UnitKind::kTime, "h");
  return are_hours ? foreignAngle("h") : nullptr;
}

const Unit* sixtiethsOfHours() { return foreignAngle("hms"); }
const Unit* sixtiethsOfDegrees() { return foreignAngle("dms"); }

OwnUnit ownUnitOf(const Unit& unit) {
  if (unit.kind != UnitKind::kAngle || foreignAngle(unit.name) != &unit) return {&unit, 1};
  const Unit* degree = findUnit(UnitKind::kAngle, "deg");
  return {degree, rounded(unit.factor / degree->factor)};
}

std::vector<std::string> foreignUnitNames(UnitKind kind) {
  auto names = unitNames(kind);
  for (const Unit& unit : kForeignAngles)
    if (unit.kind == kind) names.emplace_back(unit.name);
  return names;
}

bool isUnitWord(std::string_view word) { return findUnitWord(word) != nullptr; }

ForeignHeading parseHeading(std::string_view text) {
  auto words =
      tubesheets::splitHeading(text, [](std::string_view word) { return isUnitWord(word) || isCountWord(word); });
  const Unit* unit = words.unit.empty() ? nullptr : findUnitWord(words.unit);
  return {std::move(words.name), unit, !words.unit.empty() && !unit};
}

}  // namespace tubeplan::app
