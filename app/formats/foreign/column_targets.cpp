// columnTargets(): all quantities of a measurement table, with their names in other programs.
#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "app/formats/arm/joint_units.hpp"
#include "app/formats/foreign/foreign_columns.hpp"
#include "app/formats/foreign/foreign_heading.hpp"
#include "app/formats/measurements/measurement_columns.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "deflection/side_chains.hpp"

namespace tubeplan::app {

namespace {

void addJoints(const deflection::Arm& arm, std::vector<ColumnTarget>& targets) {
  int number = 0;
  for (const auto& joint : arm.joints()) {
    ++number;
    std::vector<std::string> aliases = {parseHeading(joint.name).name};
    for (const char* name : kJointWords) aliases.push_back(fmt::format("{}{}", name, number));
    targets.push_back(
        {.quantity = joint.name, .unit = unitKindOf(joint), .is_joint = true, .aliases = std::move(aliases)});
  }
  for (const auto* joint : deflection::sideJoints(arm))
    targets.push_back({.quantity = joint->name,
                       .unit = unitKindOf(*joint),
                       .is_joint = true,
                       .aliases = {parseHeading(joint->name).name}});
  for (const auto& joint : arm.joints()) {
    const std::string name = jointColumnName(joint) + "_dir";
    targets.push_back({.quantity = name, .unit = std::nullopt, .aliases = {parseHeading(name).name}});
  }
}

void addOwn(std::vector<ColumnTarget>& targets) {
  for (const auto& kind : calibration::measurementKinds())
    for (const auto& [name, quantity] : kind.columns) {
      const bool is_there =
          std::any_of(targets.begin(), targets.end(), [&](const auto& t) { return t.quantity == name; });
      if (is_there) continue;
      std::optional<UnitKind> unit;
      if (quantity != deflection::Quantity::kNone) unit = unitKindOf(quantity);
      targets.push_back({.quantity = name, .unit = unit, .aliases = {parseHeading(name).name}});
    }
}

ColumnTarget conditionTarget(const deflection::ConditionKind& kind) {
  const bool has_own_unit = kind.unit.quantity == deflection::Quantity::kNone;
  ColumnTarget target{.quantity = has_own_unit ? conditionColumn(kind, Units()) : kind.name, .unit = std::nullopt};
  if (!has_own_unit) target.unit = unitKindOf(kind.unit.quantity);
  target.aliases = {parseHeading(kind.name).name};
  if (has_own_unit) target.aliases.push_back(parseHeading(target.quantity).name);
  for (const char* alias : kind.aliases)
    if (alias) target.aliases.emplace_back(alias);
  return target;
}

void addForms(std::vector<ColumnTarget>& targets) {
  for (const auto& form : writtenForms())
    for (std::size_t part = 0; part < form.numbers.size(); ++part)
      targets.push_back({.quantity = fmt::format("{}.{}", form.name, form.numbers[part].name),
                         .unit = form.numbers[part].unit,
                         .form = &form,
                         .part = part});
}

}  // namespace

std::vector<ColumnTarget> columnTargets(const deflection::Arm& arm) {
  const auto text = [](const char* name, std::vector<std::string> aliases) {
    return ColumnTarget{.quantity = name, .unit = std::nullopt, .is_number = false, .aliases = std::move(aliases)};
  };
  const auto number = [](std::string name, UnitKind unit, std::vector<std::string> aliases) {
    return ColumnTarget{.quantity = std::move(name), .unit = unit, .aliases = std::move(aliases)};
  };
  std::vector<ColumnTarget> targets = {
      text("id", {"id", "no", "nr", "number", "index", "reading", "measurement"}),
      text("kind", {"kind"}),
      text("point", {"point", "pointname", "pointid", "name", "target", "label", "hole", "tube"}),
      text("setup", {"setup"}),
      text("split", {"split"}),
      text("from", {"from"}),
      // The alias `row` is excluded, because in other tables it is the row number.
      text("row", {"armrow", "link", "linkname"}),
      number("load", UnitKind::kForce, {"load", "payload", "mass", "weight"}),
  };
  addJoints(arm, targets);
  for (const char* axis : {"x", "y", "z"}) {
    std::vector<std::string> aliases;
    for (const char* form : {"{}", "pos{}", "p{}", "t{}", "{}pos", "measured{}", "{}measured", "meas{}", "{}meas",
                             "position{}", "poseposition{}"})
      aliases.push_back(fmt::format(fmt::runtime(form), axis));
    aliases.push_back(fmt::format("actualtcppose{}", axis[0] - 'x'));
    targets.push_back(number(axis, UnitKind::kLength, std::move(aliases)));
  }
  for (const char* name : {"tool_x", "tool_y", "tool_z", "sigma_x", "sigma_y", "sigma_z"})
    targets.push_back(number(name, UnitKind::kLength, {parseHeading(name).name}));
  addOwn(targets);
  for (const char* name : {"dx", "dy", "dz"})
    targets.push_back({.quantity = name, .unit = std::nullopt, .aliases = {name}});
  for (const char* name : {"rho_xy", "rho_xz", "rho_yz"})
    targets.push_back({.quantity = name, .unit = std::nullopt, .aliases = {parseHeading(name).name}});
  targets.push_back(number("sigma", UnitKind::kLength, {"sigma", "std", "stddev", "standarddeviation"}));
  targets.push_back(number("turn_sigma", UnitKind::kAngle, {"turnsigma"}));
  for (const auto& [word, letter, unit] :
       {std::tuple("force", "f", UnitKind::kForce), std::tuple("moment", "torque", UnitKind::kTorque)})
    for (const char* axis : {"x", "y", "z"})
      targets.push_back(number(fmt::format("{}_{}", word, axis), unit,
                               {fmt::format("{}{}", letter, axis), fmt::format("{}{}", word, axis)}));
  for (const auto& kind : deflection::kConditionKinds) targets.push_back(conditionTarget(kind));
  addForms(targets);
  return targets;
}

}  // namespace tubeplan::app
