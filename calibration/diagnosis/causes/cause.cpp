#include "calibration/diagnosis/causes/cause.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "calibration/independent_geometry.hpp"
#include "calibration/measurements/measurement_prediction.hpp"

namespace tubeplan::calibration {

using deflection::EffectKind, deflection::PlaceRule, deflection::Quantity;

namespace {

constexpr int kKneeLevels = 7;   // number of moments that are tried for the knee of a stiffness
constexpr int kTimeLevels = 64;  // number of times that are tried for a step
// Prior odds that a fixed stiffness is wrong; drawings rarely give accurate stiffnesses. The zeros of joints that
// follow other joints have the same odds, because their readings are not measured.
constexpr double kFreedOdds = 2;
constexpr double kGeometryOdds = 2;  // prior odds of an error in the drawing's geometry as a whole
// Fraction of an effect's prior odds that is assigned to the same effect at all joints.
constexpr double kAlikeShare = 0.3;

bool hasWeights(const deflection::Arm& arm) {
  const auto weighs = [](const auto& row) {
    return row.weight.distributed > 0 || row.weight.end > 0 || !row.weight.lumps.empty();
  };
  return std::ranges::any_of(arm.rows, weighs) || !arm.side_chains.empty();
}

/// Returns what the measurements or the arm would need for the effect to be visible; empty if it can be visible.
std::string lackOf(const EffectKind& kind, const PlacedArm& placed, const std::vector<Measurement>& measurements) {
  const deflection::Arm& arm = placed.arm;
  const auto any = [&](auto&& holds) { return std::ranges::any_of(measurements, holds); };
  const bool has_load = any([](const Measurement& m) { return m.load > 0; });
  const bool is_loaded = has_load || any([](const Measurement& m) { return m.wrench.has_value(); });
  if (kind.needs.approach_directions && !any([](const Measurement& m) {
        return std::ranges::any_of(m.approach_directions, [](int s) { return s != 0; });
      }))
    return "the readings do not state the direction of the joints' last motion (<joint>_dir)";
  for (const auto condition : conditionsOf(kind))
    if (!any([&](const Measurement& m) { return m.conditions.states(condition); }))
      return std::string("the readings do not state the ") + deflection::kindOf(condition).name;
  if (kind.needs.load && !has_load) return "no reading is under a load";
  if (kind.needs.moments && !is_loaded && !hasWeights(arm))
    return "the arm file states no weights and no reading is under a load";
  if (kind.needs.no_weights && hasWeights(arm))
    return "the arm file states weights, so compliances include this effect";
  if (kind.needs.tool_turn && !placed.shows_tool_turn)
    return "no reading states the tool's turn, or a point beside its tip";
  if (*kind.place_needs && kind.places(arm).empty()) return deflection::lackOfPlace(kind);
  return "";
}

/// Returns up to `count` evenly spaced quantiles of a sample, from probability `from` to `to`, without repeated values.
std::vector<double> quantiles(std::vector<double> sample, int count, double from, double to) {
  if (sample.empty()) return {};
  std::ranges::sort(sample);
  std::set<double> levels;
  for (int k = 0; k < count; ++k) {
    const double share = from + (to - from) * (count > 1 ? static_cast<double>(k) / (count - 1) : 0.5);
    levels.insert(sample[static_cast<std::size_t>(share * static_cast<double>(sample.size() - 1))]);
  }
  return {levels.begin(), levels.end()};
}

/// Returns the absolute moments [N m] about the axis at `place`, at an evenly spaced subset of fewer than 400
/// measurements.
std::vector<double> momentsAt(const PlacedArm& placed, const std::vector<Measurement>& measurements,
                              const deflection::Place& place) {
  constexpr std::size_t kMost = 200;
  const std::size_t step = std::max<std::size_t>(1, measurements.size() / kMost);
  std::vector<double> moments;
  for (std::size_t k = 0; k < measurements.size(); k += step) {
    const auto& X_WB = basePoseAt(placed, measurements[k]);
    const auto shape = deflection::solveFlexibleKinematics(placed.arm, postureOf(measurements[k], placed.arm, X_WB));
    if (shape.status == deflection::KinematicsStatus::kConverged)
      moments.push_back(std::abs(shape.rows[static_cast<std::size_t>(place.row)].moment_L[place.axis]));
  }
  return moments;
}

std::vector<double> levelsOf(const Cause& cause, const PlacedArm& placed,
                             const std::vector<Measurement>& measurements) {
  if (cause.shape < 0) return {0};
  const auto& parameter = kindOf(cause.effects.front()).parameters[static_cast<std::size_t>(cause.shape)];
  if (parameter.quantity == Quantity::kTorque)
    return quantiles(momentsAt(placed, measurements, cause.effects.front().place), kKneeLevels, 0.04, 0.9);
  if (parameter.quantity == Quantity::kTime) return quantiles(timesBetween(measurements), kTimeLevels, 0.05, 0.95);
  return {parameter.neutral};
}

bool isThereAlready(const deflection::Arm& arm, const deflection::Effect& effect) {
  return std::ranges::any_of(arm.effects, [&](const auto& present) { return areOne(present, effect); });
}

std::vector<std::string> placesOf(const EffectKind& kind, const PlacedArm& placed) {
  if (kind.at != PlaceRule::kSetup) return deflection::placeTexts(placed.arm, kind);
  std::vector<std::string> setups;
  for (std::size_t p = 1; p < placed.base_poses.size(); ++p) setups.push_back(placed.base_poses[p].setup);
  return setups;
}

int shapeOf(const EffectKind& kind) {
  for (std::size_t v = 0; v < kind.parameters.size(); ++v)
    if (kind.parameters[v].is_shape) return static_cast<int>(v);
  return -1;
}

bool mayActAlike(const EffectKind& kind) {
  if (shapeOf(kind) >= 0) return false;
  if (kind.at == PlaceRule::kJoint)
    return kind.stage == deflection::EffectStage::kFlexibility || kind.needs.approach_directions;
  return kind.at == PlaceRule::kRowAxis && kind.stage == deflection::EffectStage::kFlexibility &&
         kind.parameters.size() == 1;
}

/// Adds one cause for each location of an effect kind, and one for all joints together. The prior odds of the kind are
/// divided among these causes.
void addKind(const EffectKind& kind, const PlacedArm& placed, const std::vector<Measurement>& measurements,
             CauseList& list) {
  std::vector<Cause> at_places;
  for (const std::string& at : placesOf(kind, placed)) {
    const auto made = deflection::makeEffect(placed.arm, kind.name, at);
    if (isThereAlready(placed.arm, made.effect)) continue;
    Cause cause{kind.name, at, {made.effect}, {}, shapeOf(kind)};
    cause.levels = levelsOf(cause, placed, measurements);
    if (!cause.levels.empty()) at_places.push_back(std::move(cause));
  }
  if (at_places.empty()) return;
  Cause alike{kind.name, kAllJoints, effectsAtAllJoints(placed.arm, kind.name), {}};
  const bool has_alike = alike.effects.size() > 1;
  for (Cause& cause : at_places)
    cause.prior = kind.odds * (has_alike ? 1 - kAlikeShare : 1) / static_cast<double>(at_places.size());
  list.causes.insert(list.causes.end(), at_places.begin(), at_places.end());
  if (!has_alike) return;
  alike.prior = kind.odds * kAlikeShare;
  list.causes.push_back(std::move(alike));
}

bool isFree(const std::vector<Unknown>& free, const std::string& name) {
  return std::ranges::any_of(free, [&](const Unknown& unknown) { return unknown.name == name; });
}

/// Adds causes for parameters of the arm's file that the fit does not change: each stiffness, each zero of a joint that
/// follows another joint, and the drawing's geometry as a whole.
void addHeldNumbers(const PlacedArm& placed, const std::vector<Unknown>& free, CauseList& list) {
  std::vector<Cause> stiffnesses;
  Cause geometry{kFreedNumbers, kAllGeometry, {}, {}};
  for (const auto& number : independentGeometry(placed, free)) geometry.frees.push_back(number.name);
  for (const auto& parameter : deflection::parametersOf(placed.arm)) {
    if (parameter.path.effect >= 0 || isFree(free, parameter.name)) continue;
    if (deflection::isStiffness(parameter.quantity))
      stiffnesses.push_back({kFreedNumbers, parameter.name, {}, {parameter.name}});
  }
  std::vector<Cause> zeros;
  for (const auto& row : placed.arm.rows) {
    const std::string name = row.name + ".joint.offset";
    if (!row.joint.follows.empty() && !isFree(free, name)) zeros.push_back({kFreedNumbers, name, {}, {name}});
  }
  const auto addAll = [&](std::vector<Cause>& causes) {
    for (Cause& cause : causes) cause.prior = kFreedOdds / static_cast<double>(causes.size());
    list.causes.insert(list.causes.end(), causes.begin(), causes.end());
  };
  addAll(stiffnesses);
  addAll(zeros);
  if (geometry.frees.size() < 2) return;
  geometry.prior = kGeometryOdds;
  list.causes.push_back(std::move(geometry));
}

}  // namespace

std::vector<double> timesBetween(const std::vector<Measurement>& measurements) {
  std::set<double> times;
  for (const auto& measurement : measurements)
    if (measurement.conditions.states(Condition::kTime)) times.insert(measurement.conditions[Condition::kTime]);
  std::vector<double> between;
  for (auto at = times.begin(); at != times.end() && std::next(at) != times.end(); ++at)
    between.push_back((*at + *std::next(at)) / 2);
  return between;
}

const char* causeWords(const std::string& effect, const std::string& at) {
  if (effect == kFreedNumbers)
    return at == kAllGeometry ? "numbers of the arm's file are off" : "a number of the arm's file is off";
  const auto kind = deflection::findEffectKind(effect);
  return kind ? deflection::effectKinds().at(static_cast<std::size_t>(*kind)).words : "";
}

std::string causeTitle(const std::string& effect, const std::string& at) {
  if (effect == kFreedNumbers) return at + ": " + causeWords(effect, at);
  return at.empty() ? effect : effect + " at " + at;
}

std::string causeTitle(const std::string& cause) {
  const std::size_t mark = std::min(cause.find('@'), cause.size());
  return causeTitle(cause.substr(0, mark),
                    cause.substr(mark, cause.find(':', mark) - mark).substr(mark < cause.size()));
}

std::vector<std::string> causeVariables(const std::string& effect) {
  std::vector<std::string> names;
  if (const auto kind = deflection::findEffectKind(effect))
    for (const auto variable : deflection::effectKinds().at(static_cast<std::size_t>(*kind)).varies_with)
      names.emplace_back(deflection::nameOf(variable));
  return names;
}

std::vector<deflection::Effect> effectsAtAllJoints(const deflection::Arm& arm, const std::string& effect) {
  std::vector<deflection::Effect> effects;
  for (const EffectKind& kind : deflection::effectKinds()) {
    if (kind.name != effect || !mayActAlike(kind)) continue;
    // If an effect of this kind can act about several axes of a row, only the joint's rotation axis is used.
    for (const std::string& at : deflection::placeTexts(arm, kind)) {
      const auto made = deflection::makeEffect(arm, kind.name, at);
      const auto& place = made.effect.place;
      const bool turns = arm.rows[static_cast<std::size_t>(place.row)].joint.type == deflection::JointType::kRevolute;
      if (turns && (kind.at == PlaceRule::kJoint || place.axis == 2) && !isThereAlready(arm, made.effect))
        effects.push_back(made.effect);
    }
  }
  return effects;
}

bool overlap(const Cause& a, const Cause& b) {
  for (const auto& mine : a.effects)
    for (const auto& theirs : b.effects)
      if (areOne(mine, theirs)) return true;
  return std::ranges::any_of(
      a.frees, [&](const std::string& name) { return std::ranges::find(b.frees, name) != b.frees.end(); });
}

bool mayActBeside(const Cause& cause, const std::vector<deflection::Effect>& effects) {
  return std::ranges::all_of(cause.effects, [&](const auto& own) {
    const std::string_view extended = kindOf(own).extends;
    return extended.empty() || std::ranges::any_of(effects, [&](const auto& effect) {
             return kindOf(effect).name == extended && effect.place == own.place;
           });
  });
}

bool isStep(const Cause& cause) {
  return cause.shape >= 0 &&
         kindOf(cause.effects.front()).parameters[static_cast<std::size_t>(cause.shape)].quantity == Quantity::kTime;
}

Unknown numberUnknown(const deflection::Arm& arm, int effect, int value) {
  const auto& placed = arm.effects[static_cast<std::size_t>(effect)];
  const auto& parameter = kindOf(placed).parameters[static_cast<std::size_t>(value)];
  const auto number = deflection::numberOf(arm, placed, value);
  Unknown unknown;
  unknown.name = deflection::textOf(arm, placed) + "." + parameter.name;
  unknown.quantity = number.quantity;
  unknown.path.effect = effect;
  unknown.path.value = value;
  unknown.start = placed.values[static_cast<std::size_t>(value)];
  unknown.typical = parameter.plausible;
  unknown.lower = number.lower - unknown.start;
  unknown.upper = number.upper - unknown.start;
  takeSizePrior(parameter, unknown);
  // A scanned parameter has no neutral value to use as prior mean.
  if (parameter.is_shape) unknown.prior_mean = 0;
  return unknown;
}

std::vector<Unknown> placeCause(PlacedArm& placed, const Cause& cause, double level) {
  if (!cause.frees.empty()) return chooseUnknowns(placed, {cause.frees, false, placed.priors}).list;
  std::vector<Unknown> unknowns;
  for (const auto& neutral : cause.effects) {
    placed.arm.effects.push_back(neutral);
    if (cause.shape >= 0) placed.arm.effects.back().values[static_cast<std::size_t>(cause.shape)] = level;
    const int effect = static_cast<int>(placed.arm.effects.size()) - 1;
    for (int value = 0; value < static_cast<int>(neutral.values.size()); ++value)
      if (value != cause.shape) unknowns.push_back(numberUnknown(placed.arm, effect, value));
  }
  return unknowns;
}

Unknown shapeUnknown(const deflection::Arm& arm, const Cause& cause, int effect, double level) {
  Unknown unknown = numberUnknown(arm, effect, cause.shape);
  unknown.typical = std::max(1e-3, 0.3 * std::abs(level));
  return unknown;
}

CauseList listCauses(const PlacedArm& placed, const std::vector<Measurement>& measurements,
                     const std::vector<Unknown>& free, const WorkHooks& hooks) {
  CauseList list;
  for (const auto& kind : deflection::effectKinds()) {
    throwIfStopped(hooks.stop);
    if (kind.odds <= 0) continue;
    if (const std::string lack = lackOf(kind, placed, measurements); !lack.empty())
      list.not_tried.push_back(std::string(kind.name) + ": " + lack);
    else
      addKind(kind, placed, measurements, list);
  }
  addHeldNumbers(placed, free, list);
  double total = 0;
  for (const Cause& cause : list.causes) total += cause.prior;
  for (Cause& cause : list.causes) cause.prior /= total;
  return list;
}

}  // namespace tubeplan::calibration
