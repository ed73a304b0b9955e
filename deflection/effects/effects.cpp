// The effect table. A new effect is a file that states its law, and one row of this table.
#include <algorithm>

#include "deflection/effects/backlash.hpp"
#include "deflection/effects/base_drift.hpp"
#include "deflection/effects/base_slip.hpp"
#include "deflection/effects/cable_stretch.hpp"
#include "deflection/effects/contact_force.hpp"
#include "deflection/effects/encoder_eccentricity.hpp"
#include "deflection/effects/gear_wave.hpp"
#include "deflection/effects/gravity_sag.hpp"
#include "deflection/effects/gravity_tilt.hpp"
#include "deflection/effects/hose_pull.hpp"
#include "deflection/effects/hysteresis.hpp"
#include "deflection/effects/joint_compliance.hpp"
#include "deflection/effects/joint_coupling.hpp"
#include "deflection/effects/joint_offset.hpp"
#include "deflection/effects/joint_scale.hpp"
#include "deflection/effects/link_bending.hpp"
#include "deflection/effects/link_lean.hpp"
#include "deflection/effects/link_length.hpp"
#include "deflection/effects/link_torsion.hpp"
#include "deflection/effects/link_twist.hpp"
#include "deflection/effects/link_weight.hpp"
#include "deflection/effects/lost_motion.hpp"
#include "deflection/effects/payload_offset.hpp"
#include "deflection/effects/scale_error.hpp"
#include "deflection/effects/screw_coupling.hpp"
#include "deflection/effects/slide_bending.hpp"
#include "deflection/effects/stiffening.hpp"
#include "deflection/effects/thermal_growth.hpp"
#include "deflection/effects/tool_offset.hpp"
#include "deflection/effects/tool_remount.hpp"
#include "deflection/effects/tool_turn.hpp"
#include "deflection/effects/tool_weight.hpp"
#include "deflection/effects/transmission_error.hpp"
#include "deflection/effects/user_formula.hpp"

namespace tubeplan::deflection {

const std::vector<EffectKind>& effectKinds() {
  static const std::vector<EffectKind> kKinds{
      joint_offset::kind(),       joint_scale::kind(),   encoder_eccentricity::kind(),
      transmission_error::kind(), hysteresis::kind(),    joint_coupling::kind(),
      screw_coupling::kind(),     link_length::kind(),   link_twist::kind(),
      link_lean::kind(),          tool_offset::kind(),   thermal_growth::kind(),
      link_weight::kind(),        tool_weight::kind(),   payload_offset::kind(),
      gravity_tilt::kind(),       hose_pull::kind(),     contact_force::kind(),
      joint_compliance::kind(),   link_bending::kind(),  link_torsion::kind(),
      stiffening::kind(),         lost_motion::kind(),   backlash::kind(),
      base_slip::kind(),          base_drift::kind(),    scale_error::kind(),
      gravity_sag::kind(),        slide_bending::kind(), cable_stretch::kind(),
      gear_wave::kind(),          tool_remount::kind(),  tool_turn::kind(),
      user_formula::kind(),
  };
  return kKinds;
}

const char* nameOf(EffectVariable variable) {
  if (const auto condition = variable.condition()) return kindOf(*condition).name;
  switch (variable.of_) {
    case EffectVariable::kJoint:
      return "joint";
    case EffectVariable::kDirection:
      return "sense";
    case EffectVariable::kLoad:
      return "load";
    case EffectVariable::kMoment:
      return "moment";
    case EffectVariable::kPosition:
      return "position";
    case EffectVariable::kSetup:
      return "set-up";
  }
  return "";
}

std::vector<Condition> conditionsOf(const EffectKind& kind) {
  std::vector<Condition> conditions;
  for (const EffectVariable variable : kind.varies_with)
    if (const auto condition = variable.condition()) conditions.push_back(*condition);
  return conditions;
}

const EffectKind& kindOf(const Effect& effect) { return effectKinds().at(static_cast<std::size_t>(effect.kind)); }

std::optional<int> findEffectKind(std::string_view name) {
  const auto& kinds = effectKinds();
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const EffectKind& kind) { return kind.name == name; });
  if (found == kinds.end()) return std::nullopt;
  return static_cast<int>(found - kinds.begin());
}

std::string placeText(const Arm& arm, const Effect& effect) {
  if (effect.formula) return effect.formula->at;
  return textOf(arm, kindOf(effect), effect.place);
}

std::string textOf(const Arm& arm, const Effect& effect) {
  return std::string(kindOf(effect).name) + "@" + placeText(arm, effect);
}

std::string lackOfPlace(const EffectKind& kind) {
  const std::string needs = kind.place_needs;
  return needs.empty() ? "this arm has no place for this effect"
                       : "this arm has no place for this effect, which needs " + needs;
}

MadeEffect makeEffect(const Arm& arm, std::string_view name, std::string_view at) {
  MadeEffect made;
  const auto index = findEffectKind(name);
  if (!index) {
    made.status = EffectStatus::kUnknownEffect;
    made.reason = "there is no effect of that name";
    for (const EffectKind& kind : effectKinds()) made.known.emplace_back(kind.name);
    return made;
  }
  const EffectKind& kind = effectKinds()[*index];
  const auto place = findPlace(arm, kind, at);
  if (!place) {
    made.status = EffectStatus::kUnknownPlace;
    made.known = placeTexts(arm, kind);
    made.reason = made.known.empty() ? lackOfPlace(kind) : "this effect has no such place on this arm";
    if (name == user_formula::kName) made.reason = "a formula is given as a text, such as 'theta3 += c*sin(3*theta1)'";
    return made;
  }
  made.status = EffectStatus::kMade;
  made.effect = {*index, *place, {}};
  for (const auto& parameter : kind.parameters) made.effect.values.push_back(parameter.neutral);
  return made;
}

const std::vector<EffectParameter>& numbersOf(const Effect& effect) {
  return effect.formula ? effect.formula->parameters : effectKinds().at(effect.kind).parameters;
}

EffectNumber numberOf(const Arm& arm, const Effect& effect, int value) {
  const EffectKind& kind = effectKinds().at(effect.kind);
  const EffectParameter& parameter = numbersOf(effect).at(value);
  EffectNumber number{parameter.quantity, parameter.lower, parameter.upper};
  if (parameter.least) number.lower = parameter.least(arm, effect.place);
  if (effect.formula) return number;
  const bool of_slide =
      kind.stage == EffectStage::kJointReading && arm.rows.at(effect.place.row).joint.type == JointType::kPrismatic;
  if (of_slide && number.quantity == Quantity::kAngle) number.quantity = Quantity::kLength;
  return number;
}

}  // namespace tubeplan::deflection
