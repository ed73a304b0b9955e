#include "calibration/watch/candidate_changes.hpp"

#include <algorithm>

#include "deflection/effects/effect.hpp"

namespace tubeplan::calibration {

using deflection::ConditionKind, deflection::EffectStage;

namespace {

constexpr double kBaseShift = 0.02, kBaseTurn = 0.02;  // largest plausible displacement of a base [m, rad]
constexpr double kBaseOdds = 0.25;  // prior odds of a displacement of the base against all other causes together

struct StageRow {
  EffectStage stage;
  Remedy remedy;
};
constexpr StageRow kStages[] = {
    {EffectStage::kJointReading, Remedy::kReferenceJoint}, {EffectStage::kGeometry, Remedy::kRemeasureArm},
    {EffectStage::kLoad, Remedy::kRemeasureArm},           {EffectStage::kFlexibility, Remedy::kInspectJoint},
    {EffectStage::kBase, Remedy::kCalibrateBase},          {EffectStage::kMeasurement, Remedy::kRemeasureArm},
};

bool dependsOn(const deflection::Effect& effect, Condition condition) {
  const auto conditions = deflection::conditionsOf(kindOf(effect));
  return std::ranges::find(conditions, condition) != conditions.end();
}

Remedy remedyOf(const Cause& cause) {
  if (cause.effects.empty()) return Remedy::kInspectJoint;
  if (dependsOn(cause.effects.front(), Condition::kTemperature)) return Remedy::kAwaitWarmth;
  return std::ranges::find(kStages, kindOf(cause.effects.front()).stage, &StageRow::stage)->remedy;
}

/// Measurements in which each condition that none of them states differs from its usual value, so that effects of the
/// condition show; with the arm freed of the effects that the watched model has but does not apply without the
/// condition.
struct AssumedConditions {
  PlacedArm placed;
  std::vector<Measurement> measurements;
  std::vector<const ConditionKind*> assumed;
};

AssumedConditions withAssumedConditions(const PlacedArm& placed, const std::vector<Measurement>& measurements) {
  AssumedConditions result{placed, measurements, {}};
  for (const ConditionKind& kind : deflection::kConditionKinds) {
    const auto states = [&](const Measurement& m) { return m.conditions.states(kind.condition); };
    if (kind.change == 0 || std::ranges::any_of(measurements, states)) continue;
    for (Measurement& measurement : result.measurements)
      measurement.conditions[kind.condition] = placed.arm.reference[kind.condition] + kind.change;
    std::erase_if(result.placed.arm.effects, [&](const auto& effect) { return dependsOn(effect, kind.condition); });
    result.assumed.push_back(&kind);
  }
  return result;
}

/// Returns true if a cause is one place of one effect, or one number, that can change while the arm works. A step in
/// time is left to the watch, which tries every start itself.
bool canChange(const Cause& cause) {
  if (isStep(cause) || cause.effects.size() + cause.frees.size() != 1) return false;
  return cause.effects.empty() || !dependsOn(cause.effects.front(), Condition::kTime);
}

CandidateChange baseMoved(double prior) {
  CandidateChange change{kBaseMoved, "base", prior, Remedy::kCalibrateBase, {}, {}, {}, 0};
  for (int k = 0; k < 6; ++k) {
    const bool is_shift = k < 3;
    change.numbers.push_back({baseStepNames()[static_cast<std::size_t>(k)],
                              is_shift ? deflection::Quantity::kLength : deflection::Quantity::kAngle,
                              is_shift ? kBaseShift : kBaseTurn,
                              -deflection::kUnbounded,
                              deflection::kUnbounded,
                              {}});
    change.columns.push_back(k);
  }
  return change;
}

/// Returns the numbers of a cause, with their columns `of_cause` among those of all causes.
CandidateChange changeBy(const AssumedConditions& conditions, const Cause& cause, const std::vector<int>& of_cause,
                         const std::vector<SignatureColumn>& signatures) {
  CandidateChange change{cause.effect, cause.at, cause.prior, remedyOf(cause), {}, {}, {}, 0};
  PlacedArm with = conditions.placed;
  const auto unknowns = placeCause(with, cause, cause.levels[cause.levels.size() / 2]);
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    const auto& column = signatures[static_cast<std::size_t>(of_cause[k])];
    change.numbers.push_back(
        {unknowns[k].name, unknowns[k].quantity, unknowns[k].typical, column.lower, column.upper, unknowns[k]});
    change.columns.push_back(6 + of_cause[k]);
  }
  for (const ConditionKind* kind : conditions.assumed)
    if (!cause.effects.empty() && dependsOn(cause.effects.front(), kind->condition)) {
      change.assumed = kind->condition;
      change.assumed_change = kind->change;
    }
  return change;
}

}  // namespace

CandidateChanges candidateChanges(const PlacedArm& placed, const std::vector<Measurement>& measurements,
                                  const MeasurementWeights& weights, const Eigen::MatrixXd& by_base,
                                  const StopQuestion& stop) {
  const AssumedConditions conditions = withAssumedConditions(placed, measurements);
  WorkHooks hooks;
  hooks.stop = stop;
  auto causes = listCauses(conditions.placed, conditions.measurements, {}, hooks).causes;
  std::erase_if(causes, [&](const Cause& cause) {
    return !canChange(cause) || !mayActBeside(cause, conditions.placed.arm.effects);
  });
  for (Cause& cause : causes) cause.levels = {cause.levels[cause.levels.size() / 2]};
  const Signatures signatures(conditions.placed, causes);
  CandidateChanges changes;
  const Eigen::MatrixXd columns = signatures.columnsAt(conditions.measurements, weights, stop);
  if (columns.rows() != by_base.rows()) return changes;
  changes.columns.resize(by_base.rows(), 6 + columns.cols());
  changes.columns << by_base.leftCols<3>() * kBaseShift, by_base.rightCols<3>() * kBaseTurn, columns;
  double total = kBaseOdds;
  for (const Cause& cause : causes) total += cause.prior;
  changes.list.push_back(baseMoved(kBaseOdds));
  for (std::size_t c = 0; c < causes.size(); ++c) {
    auto change = changeBy(conditions, causes[c], signatures.columnsOf(static_cast<int>(c), 0), signatures.columns());
    if (changes.columns(Eigen::all, change.columns).norm() > 0)
      changes.list.push_back(std::move(change));
    else
      changes.not_seen.push_back(change.effect + "@" + change.at);
  }
  for (auto& change : changes.list) change.prior /= total;
  return changes;
}

}  // namespace tubeplan::calibration
