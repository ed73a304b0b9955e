#include "app/formats/units_json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "deflection/conditions.hpp"

namespace tubeplan::app {

nlohmann::json unitsJson(const Units& units) {
  return {{"length", units.length().name},
          {"angle", units.angle().name},
          {"force", units.force().name},
          {"temperature", units.temperature().name},
          {"time", units.time().name}};
}

nlohmann::json measurementUnitsJson(const Units& units) {
  nlohmann::json json = unitsJson(units), conditions = nlohmann::json::array();
  for (const auto& kind : deflection::kConditionKinds)
    conditions.push_back({{"name", kind.name}, {"unit", units.nameOf(kind.unit)}});
  json["conditions"] = conditions;
  return json;
}

nlohmann::json unitTableJson() {
  nlohmann::json table;
  for (const auto& [name, kind] : {std::pair("length", UnitKind::kLength), std::pair("angle", UnitKind::kAngle)})
    for (const Unit& unit : unitTable())
      if (unit.kind == kind) table[name].push_back({{"name", unit.name}, {"factor", unit.factor}});
  return table;
}

}  // namespace tubeplan::app
