#include "calibration/placed_arm.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "calibration/independent_geometry.hpp"
#include "deflection/effects/effect.hpp"
#include "deflection/rotation.hpp"
#include "deflection/weights.hpp"

namespace tubeplan::calibration {

namespace {

using deflection::isStiffness, deflection::Parameter, deflection::Quantity;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kStiffest = 1e4;  // largest stiffness of an axis in a fit, as a multiple of its start value
constexpr double kSoftest = 100;   // largest compliance of an axis in a fit, as a multiple of its typical compliance
// Start value for rigid axes that are freed: rotation under the arm's whole weight at full reach [rad].
constexpr double kNearlyRigid = 1e-5;
constexpr double kMayGive = 0.02;  // typical rotation of an axis under the arm's whole weight at full reach [rad]

/// Returns the arm's weight [N], or 100 N if the arm's file states no weight.
double usualWeightOf(const deflection::Arm& arm) {
  const double weight = deflection::weightOf(arm);
  return weight > 0 ? weight : 100;
}

/// Returns the likely error of a parameter: 0.5 % of the reach for lengths, about a degree for angles, a tenth of the
/// arm's weight for forces, the plausible magnitude for effects, and a tenth of the value for others. Returns 1 for
/// stiffnesses, for which typicalCompliance() is used instead.
double typicalOf(const Parameter& parameter, const deflection::Arm& arm) {
  if (parameter.path.effect >= 0) {
    const auto& effect = arm.effects.at(static_cast<std::size_t>(parameter.path.effect));
    return deflection::numbersOf(effect).at(static_cast<std::size_t>(parameter.path.value)).plausible;
  }
  switch (parameter.quantity) {
    case Quantity::kLength:
      return 0.005 * deflection::reachOf(arm);
    case Quantity::kAngle:
      return 0.02;
    case Quantity::kForce:
      return 0.1 * usualWeightOf(arm);
    case Quantity::kForcePerLength:
      return 0.1 * usualWeightOf(arm) / deflection::reachOf(arm);
    default:
      return isStiffness(parameter.quantity) ? 1 : std::max(0.1 * std::abs(parameter.value), 1e-3);
  }
}

/// Returns the factor that converts a stiffness parameter to an angular stiffness [N m/rad]: 1 for a joint, and for a
/// beam the other factors of E I / L or G J / L.
double angleStiffnessOf(const Parameter& parameter, const deflection::Arm& arm) {
  if (parameter.quantity == Quantity::kTorquePerAngle) return 1;
  const auto& beam = *arm.rows.at(static_cast<std::size_t>(parameter.path.row)).beam;
  const double length = deflection::reachOf(arm) / static_cast<double>(arm.rows.size());
  const bool is_torsion = parameter.name.ends_with(".G") || parameter.name.ends_with(".J");
  if (parameter.quantity == Quantity::kPressure) return (is_torsion ? beam.J : beam.I.minCoeff()) / length;
  return (is_torsion ? beam.G : beam.E) / length;
}

/// Returns the larger of two compliances: the nominal one, and the one that would deflect the axis by the typical angle
/// kMayGive under the arm's weight. The nominal compliance alone does not suffice, because the start may be far too
/// stiff.
double typicalCompliance(const Parameter& parameter, const deflection::Arm& arm) {
  const double moment = usualWeightOf(arm) * deflection::reachOf(arm);
  const double of_angle = kMayGive / moment * angleStiffnessOf(parameter, arm);
  return std::isfinite(of_angle) ? std::max(1 / parameter.value, of_angle) : 1 / parameter.value;
}

Unknown armUnknown(const Parameter& parameter, const deflection::Arm& arm, bool was_rigid) {
  Unknown unknown;
  unknown.name = parameter.name;
  unknown.quantity = parameter.quantity;
  unknown.path = parameter.path;
  unknown.start = parameter.value;
  unknown.typical = typicalOf(parameter, arm);
  if (isStiffness(parameter.quantity) && parameter.path.effect < 0) {
    unknown.scale = Unknown::Scale::kCompliance;
    unknown.typical = typicalCompliance(parameter, arm);
    unknown.lower = (was_rigid ? -0.99 : 1 / kStiffest - 1) / parameter.value;
    unknown.upper = kSoftest * unknown.typical;
  } else {
    unknown.lower = parameter.lower - parameter.value;
    unknown.upper = parameter.upper - parameter.value;
  }
  return unknown;
}

/// Returns true for a row's beta that has nearly the same effect as the offset of the preceding joint. Such a beta is
/// not freed together with the other parameters of its row.
bool isReplaced(const Parameter& parameter, const deflection::Arm& arm) {
  return parameter.name.ends_with(".beta") && parameter.path.side_chain < 0 && parameter.value == 0 &&
         !deflection::isNearlyParallel(arm.rows.at(static_cast<std::size_t>(parameter.path.row)));
}

/// Returns true for the magnitude of an effect in the catalogue. Its likely value is known, unlike the magnitude of a
/// user's formula or a shape parameter.
bool isSizeOfCatalogue(const Unknown& unknown, const deflection::Arm& arm) {
  if (unknown.path.effect < 0) return false;
  const auto& effect = arm.effects.at(static_cast<std::size_t>(unknown.path.effect));
  return !effect.formula && !deflection::numbersOf(effect).at(static_cast<std::size_t>(unknown.path.value)).is_shape;
}

void takePrior(const Priors& priors, const deflection::Arm& arm, Unknown& unknown) {
  if (const auto own = priors.named.find(unknown.name); own != priors.named.end()) {
    unknown.prior_sigma = own->second;
  } else if (isSizeOfCatalogue(unknown, arm)) {
    const auto& effect = arm.effects.at(static_cast<std::size_t>(unknown.path.effect));
    takeSizePrior(deflection::numbersOf(effect).at(static_cast<std::size_t>(unknown.path.value)), unknown);
  } else if (unknown.owner == Unknown::Owner::kBase || !isGeometry(unknown.name)) {
    unknown.prior_sigma = priors.weak * unknown.typical;
  } else if (unknown.name.starts_with("tool.tip.")) {
    unknown.prior_sigma = priors.tip;
  } else if (unknown.name.starts_with("tool.turn.")) {
    unknown.prior_sigma = priors.turn;
  } else {
    unknown.prior_sigma = unknown.quantity == Quantity::kAngle ? priors.angle : priors.length;
  }
}

void addBase(const PlacedArm& placed, std::vector<Unknown>& list) {
  for (int p = 0; p < static_cast<int>(placed.base_poses.size()); ++p) {
    const BasePose& base_pose = placed.base_poses[static_cast<std::size_t>(p)];
    if (base_pose.is_known) continue;
    for (int k = 0; k < 6; ++k) {
      Unknown unknown;
      unknown.owner = Unknown::Owner::kBase;
      unknown.name =
          baseStepNames()[static_cast<std::size_t>(k)] + (base_pose.setup.empty() ? "" : "@" + base_pose.setup);
      unknown.quantity = k < 3 ? Quantity::kLength : Quantity::kAngle;
      unknown.base_pose = p;
      unknown.component = k;
      unknown.typical = k < 3 ? deflection::reachOf(placed.arm) : 1;
      unknown.lower = -kInfinity;
      unknown.upper = kInfinity;
      list.push_back(unknown);
    }
  }
}

/// Turns the stiffness of a rigid joint axis into a parameter, by giving it a finite value at which the axis hardly
/// deflects under the arm's weight. Returns false if `name` does not name a rigid joint axis.
bool soften(deflection::Arm& arm, const std::string& name) {
  const std::size_t dot = name.find(".joint_stiffness.");
  if (dot == std::string::npos || name.size() != dot + 18) return false;
  const auto axis = std::string_view("xyz").find(name.back());
  if (axis == std::string_view::npos) return false;
  for (auto& row : arm.rows) {
    if (row.name != name.substr(0, dot)) continue;
    auto& stiffness = row.joint_stiffness[static_cast<Eigen::Index>(axis)];
    if (std::isfinite(stiffness)) return false;
    stiffness = usualWeightOf(arm) * deflection::reachOf(arm) / kNearlyRigid;
    return true;
  }
  return false;
}

}  // namespace

int basePoseOf(const PlacedArm& placed, const Measurement& measurement) {
  const auto found = std::find_if(placed.base_poses.begin(), placed.base_poses.end(),
                                  [&](const BasePose& p) { return p.setup == measurement.setup; });
  assert(found != placed.base_poses.end());
  return static_cast<int>(found - placed.base_poses.begin());
}

const Eigen::Isometry3d& basePoseAt(const PlacedArm& placed, const Measurement& measurement) {
  return placed.base_poses[static_cast<std::size_t>(basePoseOf(placed, measurement))].X_WB;
}

std::vector<std::string> namesBehind(const deflection::Arm& arm, const std::string& name) {
  const bool is_part = name.find('.') != std::string::npos;
  // The shift of the first axis is excluded unless the file states it, because an unknown base pose has the same
  // effect.
  const auto isPartOf = [&](const Parameter& parameter) {
    return is_part && parameter.name.starts_with(name + ".") &&
           !(isShiftOfFirstAxis(parameter.name) && parameter.value == 0);
  };
  std::vector<std::string> names;
  for (const auto& parameter : deflection::parametersOf(arm))
    if ((name == "geometry" ? isGeometry(parameter.name) : isPartOf(parameter)) && !isReplaced(parameter, arm))
      names.push_back(parameter.name);
  return names.empty() && name != "geometry" ? std::vector<std::string>{name} : names;
}

namespace {

/// Adds the geometric parameters that are independent of those already free. The prior of each also covers the errors
/// of the fixed parameters that it absorbs.
void addGeometry(const PlacedArm& placed, std::vector<Unknown>& list) {
  for (const auto& number : independentGeometry(placed, list)) {
    Unknown unknown = armUnknown(*deflection::findParameter(placed.arm, number.name), placed.arm, false);
    unknown.is_geometry = true;
    takePrior(placed.priors, placed.arm, unknown);
    if (!placed.priors.named.contains(number.name))
      unknown.prior_sigma = std::hypot(unknown.prior_sigma, number.others_sigma);
    list.push_back(std::move(unknown));
  }
}

}  // namespace

std::vector<std::string> freeableNames(const deflection::Arm& arm) {
  std::vector<std::string> names{"geometry"};
  for (const auto& parameter : deflection::parametersOf(arm)) {
    std::string name = parameter.name;
    for (std::size_t dot = name.rfind('.'); dot != std::string::npos; dot = name.rfind('.')) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
      name.resize(dot);
    }
  }
  return names;
}

Unknowns chooseUnknowns(PlacedArm& placed, const FreeChoice& choice) {
  placed.priors = choice.priors;
  Unknowns result;
  if (choice.base) addBase(placed, result.list);
  const auto is_free = [&](const std::string& name) {
    return std::any_of(result.list.begin(), result.list.end(), [&](const Unknown& u) { return u.name == name; });
  };
  if (std::count(choice.names.begin(), choice.names.end(), "geometry") > 1)
    result.problems.push_back({"geometry", "'geometry' is freed twice", "name it once"});
  for (const auto& group : choice.names) {
    if (group == "geometry") continue;
    for (const auto& name : namesBehind(placed.arm, group)) {
      const bool softened = soften(placed.arm, name);
      const auto parameter = deflection::findParameter(placed.arm, name);
      if (!parameter)
        result.problems.push_back(
            {group, "the arm has no number '" + name + "'", "give the path of a number in the arm file", true});
      else if (is_free(name))
        result.problems.push_back({group, "'" + name + "' is freed twice", "name it once"});
      else
        result.list.push_back(armUnknown(*parameter, placed.arm, softened));
    }
  }
  for (Unknown& unknown : result.list) takePrior(choice.priors, placed.arm, unknown);
  if (std::ranges::count(choice.names, "geometry") > 0) addGeometry(placed, result.list);
  return result;
}

void takeSizePrior(const deflection::EffectParameter& parameter, Unknown& unknown) {
  unknown.prior_sigma = unknown.typical;
  unknown.prior_mean = parameter.neutral - unknown.start;
}

double valueAt(const Unknown& unknown, double x) {
  return unknown.scale == Unknown::Scale::kCompliance ? 1 / (1 / unknown.start + x) : unknown.start + x;
}

Unknown rebased(Unknown unknown, double value) {
  if (unknown.owner == Unknown::Owner::kBase) return unknown;
  const double x = variableAt(unknown, value);
  unknown.start = value;
  unknown.lower -= x;
  unknown.upper -= x;
  unknown.prior_mean -= x;
  return unknown;
}

double variableAt(const Unknown& unknown, double value) {
  return unknown.scale == Unknown::Scale::kCompliance ? 1 / value - 1 / unknown.start : value - unknown.start;
}

double slopeAt(const Unknown& unknown, double x) {
  const double value = valueAt(unknown, x);
  return unknown.scale == Unknown::Scale::kCompliance ? -value * value : 1;
}

std::pair<double, double> valuesBetween(const Unknown& unknown, double lower, double upper) {
  if (unknown.scale == Unknown::Scale::kLinear) return {valueAt(unknown, lower), valueAt(unknown, upper)};
  const bool may_be_rigid = lower <= unknown.lower;
  return {valueAt(unknown, upper), may_be_rigid ? deflection::kRigid : valueAt(unknown, lower)};
}

const std::array<std::string, 6>& baseStepNames() {
  static const std::array<std::string, 6> kNames{"base.shift.x", "base.shift.y", "base.shift.z",
                                                 "base.turn.x",  "base.turn.y",  "base.turn.z"};
  return kNames;
}

Eigen::Isometry3d moved(const Eigen::Isometry3d& X_WB, const BaseStep& step) {
  Eigen::Isometry3d result = X_WB;
  result.translation() += step.head<3>();
  result.linear() = deflection::rotationFromVector<double>(step.tail<3>()) * X_WB.linear();
  return result;
}

void apply(const PlacedArm& start, const std::vector<Unknown>& unknowns, const Eigen::VectorXd& x, PlacedArm& placed) {
  std::vector<BaseStep> steps(placed.base_poses.size(), BaseStep::Zero());
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    const Unknown& unknown = unknowns[k];
    const double value = x[static_cast<Eigen::Index>(k)];
    if (unknown.owner == Unknown::Owner::kBase)
      steps[static_cast<std::size_t>(unknown.base_pose)][unknown.component] = value;
    else
      deflection::locate(placed.arm, unknown.path) = valueAt(unknown, value);
  }
  for (std::size_t p = 0; p < steps.size(); ++p) placed.base_poses[p].X_WB = moved(start.base_poses[p].X_WB, steps[p]);
}

PlacedArm applied(const PlacedArm& start, const std::vector<Unknown>& unknowns, const Eigen::VectorXd& x) {
  PlacedArm placed = start;
  apply(start, unknowns, x, placed);
  return placed;
}

}  // namespace tubeplan::calibration
