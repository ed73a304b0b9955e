#include "app/formats/unit_names.hpp"

#include <algorithm>
#include <cmath>

#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

const Unit* unitNamed(std::string_view name) {
  const auto unit = std::ranges::find(unitTable(), name, &Unit::name);
  return unit == unitTable().end() ? nullptr : &*unit;
}

/// Converts one factor of a product, such as "in^4".
std::optional<ConvertedUnit> convertedPower(std::string_view text, const TargetUnits& target) {
  const auto caret = text.find('^');
  const auto exponent = caret == text.npos ? std::optional(1) : tubesheets::parseInteger(text.substr(caret + 1));
  const Unit* unit = unitNamed(text.substr(0, caret));
  if (!unit || !exponent) return std::nullopt;
  ConvertedUnit power = target.of(*unit);
  power.factor = std::pow(power.factor, *exponent);
  if (caret != text.npos) power.name += text.substr(caret);
  return power;
}

/// Converts a product, such as "lbf*in" or "(lbf*in)".
std::optional<ConvertedUnit> convertedProduct(std::string_view text, const TargetUnits& target) {
  const bool is_enclosed = text.starts_with('(') && text.ends_with(')');
  std::string_view remaining = is_enclosed ? text.substr(1, text.size() - 2) : text;
  ConvertedUnit product{is_enclosed ? "(" : "", 1};
  while (true) {
    const auto star = remaining.find('*');
    const auto factor_unit = convertedPower(remaining.substr(0, star), target);
    if (!factor_unit) return std::nullopt;
    product.name += factor_unit->name;
    product.factor *= factor_unit->factor;
    if (star == remaining.npos) break;
    product.name += "*";
    remaining.remove_prefix(star + 1);
  }
  if (is_enclosed) product.name += ")";
  return product;
}

}  // namespace

TargetUnits TargetUnits::si() {
  TargetUnits si(nullptr, nullptr);
  si.targets_ = {{{"m"}, {"rad"}, {"N"}, {"N*m"}, {"K"}, {"s"}}};
  return si;
}

TargetUnits::TargetUnits(const Unit* length, const Unit* angle) {
  for (const Unit* unit : {length, angle})
    if (unit) targets_.at(static_cast<std::size_t>(unit->kind)) = {unit->name, unit->factor};
}

ConvertedUnit TargetUnits::of(const Unit& unit) const {
  const Target& target = targets_.at(static_cast<std::size_t>(unit.kind));
  if (target.name.empty()) return {std::string(unit.name), 1};
  return {std::string(target.name), unit.factor / target.size};
}

std::optional<ConvertedUnit> convertedUnit(std::string_view name, const TargetUnits& target) {
  if (const Unit* unit = unitNamed(name); unit && unit->kind == UnitKind::kTemperature)
    return ConvertedUnit{std::string(name), 1};
  const auto slash = name.find('/');
  const std::string_view over = name.substr(0, slash);
  auto unit = over == "1" && slash != name.npos ? std::optional(ConvertedUnit{"1", 1}) : convertedProduct(over, target);
  if (!unit || slash == name.npos) return unit;
  const auto under = convertedProduct(name.substr(slash + 1), target);
  if (!under) return std::nullopt;
  return ConvertedUnit{unit->name + "/" + under->name, unit->factor / under->factor};
}

}  // namespace tubeplan::app
