#include "app/documents/moments_json.hpp"

#include <nlohmann/json.hpp>

#include "app/formats/cell/effects_reader.hpp"
#include "app/studies/model/cell_fit.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "deflection/effects/user_formula.hpp"

namespace tubeplan::app {

nlohmann::json momentsJson(const Cell& cell, const std::vector<calibration::Measurement>& all) {
  const auto placed = placedWhereRead(cell, all);
  auto symbols = deflection::formulaSymbols(cell.arm, formulaUnitsOf(cell.units));
  std::erase_if(symbols, [](const auto& named) { return named.symbol.of != deflection::FormulaSymbol::Of::kMoment; });
  nlohmann::json names = nlohmann::json::array(), measurements = nlohmann::json::object();
  for (const auto& named : symbols) names.push_back(named.name);
  for (const auto& measurement : all) {
    const auto& X_WB = placed.base_poses[static_cast<std::size_t>(basePoseOf(placed, measurement))].X_WB;
    const auto posture = calibration::postureOf(measurement, cell.arm, X_WB);
    deflection::EffectContext<double> context(cell.arm, posture);
    nlohmann::json moments = nlohmann::json::array();
    for (const auto& named : symbols)
      moments.push_back(rounded(deflection::user_formula::valueOf(named.symbol, context)));
    measurements[measurement.id] = std::move(moments);
  }
  return {{"unit", cell.units.nameOf(dimension::kTorque)}, {"names", names}, {"readings", measurements}};
}

}  // namespace tubeplan::app
