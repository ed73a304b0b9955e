#include "app/files/foreign/foreign_heading.hpp"

#include <utility>

#include "app/files/lower_case.hpp"
#include "tubesheets/length_unit.hpp"
#include "tubesheets/text_table.hpp"

namespace tubeplan::app {

namespace {

struct UnitWord {
  std::string_view word;
  UnitKind kind;
  std::string_view name;
};

/// Beside the program's own names of units.
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
  return nullptr;
}

bool isUnitWord(std::string_view word) { return findUnitWord(word) != nullptr; }

ForeignHeading parseHeading(std::string_view text) {
  auto words = tubesheets::splitHeading(text, isUnitWord);
  return {std::move(words.name), words.unit.empty() ? nullptr : findUnitWord(words.unit)};
}

}  // namespace tubeplan::app
