#include "app/documents/signature_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/formats/arm/joint_units.hpp"
#include "app/formats/cell/effects_reader.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"
#include "deflection/effects/signature.hpp"

namespace tubeplan::app {

namespace {

using deflection::EffectVariable, deflection::Quantity;
using nlohmann::json;

/// Abscissa of a signature plot: name of the variable and unit of its values.
struct Variable {
  std::string name;
  deflection::ValueUnit unit;
};

Variable variableOf(const Cell& cell, const deflection::Signature& signature) {
  if (!signature.kind) return {};
  if (const auto condition = signature.kind->condition()) return {kindOf(*condition).name, kindOf(*condition).unit};
  if (signature.kind->is(EffectVariable::kLoad)) return {"load", {Quantity::kForce}};
  const auto& joint = cell.arm.joint(signature.joint);
  if (signature.kind->is(EffectVariable::kDirection))
    return {"direction of approach of " + joint.name, {Quantity::kNone, "1"}};
  const bool slides = joint.type == deflection::JointType::kPrismatic;
  return {joint.name, {slides ? Quantity::kLength : Quantity::kAngle}};
}

}  // namespace

json signatureJson(const Cell& cell, const std::string& effect, const std::string& at, double most_load) {
  const auto made = deflection::makeEffect(cell.arm, effect, at);
  if (made.status == deflection::EffectStatus::kUnknownEffect)
    throw InputError("effect", inQuotes(effect), "an effect of the catalogue", suggestion(effect, made.known));
  if (made.status != deflection::EffectStatus::kMade) throw placeError("at", made, effect, at);
  const auto signature = deflection::signatureOf(cell.arm, made.effect, deflection::gravityInBase(cell.arm, cell.X_WB),
                                                 {.most_load = most_load});
  const Variable variable = variableOf(cell, signature);
  json values = json::array(), shift = json::array();
  for (std::size_t k = 0; k < signature.at.size(); ++k) {
    values.push_back(cell.units.toFile(signature.at[k], variable.unit));
    shift.push_back(std::isfinite(signature.shift[k]) ? json(lengthOf(signature.shift[k], cell.units)) : json());
  }
  return {{"effect", effect},
          {"at", at},
          {"variable", variable.name},
          {"unit", cell.units.nameOf(variable.unit)},
          {"values", values},
          {"shift", shift},
          {"shift_unit", cell.units.length().name}};
}

}  // namespace tubeplan::app
