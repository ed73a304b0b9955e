#include "calibration/measurement_checks/plain_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "calibration/measurement_checks/check_words.hpp"
#include "calibration/measurement_checks/copies.hpp"
#include "calibration/measurement_checks/joint_limits.hpp"
#include "calibration/measurement_checks/joint_scale.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/measurements/measurement_problems.hpp"
#include "deflection/discretisation.hpp"
#include "deflection/weights.hpp"

namespace tubeplan::calibration {

namespace {

/// Returns a remark if all joint readings are as small as angles in radians, and would be within the joint limits if
/// they were in radians. Touches of unknown points fit equally well in either unit, so their errors do not reveal this
/// mistake.
std::optional<MeasurementCheck> smallAngles(const CheckedMeasurements& checked) {
  constexpr double kTurn = 2 * std::numbers::pi;
  constexpr std::size_t kFew = 4;
  const auto& arm = checked.start.arm;
  const double factor = checked.units.angles.factor;
  if (checked.measurements.size() < kFew || factor == 1) return std::nullopt;
  double largest = 0;
  for (const int j : turningJoints(arm)) {
    const auto& joint = arm.joint(j);
    for (const auto& measurement : checked.measurements) {
      const double number = measurement.q[j] / factor;
      if (std::abs(number) > kTurn || number < joint.lower || number > joint.upper) return std::nullopt;
      largest = std::max(largest, std::abs(number));
    }
  }
  if (largest == 0) return std::nullopt;
  return remarkOf(
      "angles",
      fmt::format("no joint reading is larger than {:.4g} {}: are they radians?", largest, checked.units.angles.name),
      "angles=rad");
}

/// Returns a remark on joints whose readings exceed the range of any real joint. It asks the user for their scales,
/// in case no fit has found them.
std::optional<MeasurementCheck> pulses(const CheckedMeasurements& checked) {
  const auto joints = mistakes::joint_scale::jointsBeyondTurns(checked);
  if (joints.empty()) return std::nullopt;
  std::vector<std::string> names;
  for (const int joint : joints) names.push_back(checked.start.arm.joint(joint).name);
  const auto& unit = checked.units.angles;
  return remarkOf("joint-scale",
                  fmt::format("the readings of {} exceed the range of a joint: are they encoder pulses? State the size "
                              "of a pulse in {}, joint by joint, as --assume joint-scale={}:FACTOR",
                              listOf(names), unit.name, names.front()));
}

std::optional<MeasurementCheck> heavyLoad(const CheckedMeasurements& checked) {
  constexpr double kTimesTheArm = 10;
  const auto& arm = checked.start.arm;
  const double weight = deflection::weightOf(arm);
  double heaviest = 0;
  for (const auto& measurement : checked.measurements) heaviest = std::max(heaviest, measurement.load);
  if (weight == 0 || heaviest < kTimesTheArm * weight) return std::nullopt;
  const auto& unit = checked.units.loads;
  return remarkOf(
      "loads",
      fmt::format("a load of {:.4g} {} hangs on an arm that weighs less than {:.4g} {}: is the load's unit right?",
                  heaviest / unit.factor, unit.name, weight / unit.factor, unit.name));
}

/// Returns a remark on beams that are divided into too few segments, so that the discretisation error exceeds half the
/// noise of the measurements. It is evaluated at the measurement with the heaviest load and at several others.
std::optional<MeasurementCheck> fewSegments(const CheckedMeasurements& checked) {
  constexpr std::size_t kMostSolved = 8;
  constexpr double kOfNoise = 0.5;
  const auto& placed = checked.start;
  if (deflection::mostSegments(placed.arm) == 0) return std::nullopt;
  std::vector<const Measurement*> heaviest;
  for (const auto& measurement : checked.measurements) heaviest.push_back(&measurement);
  std::ranges::stable_sort(heaviest, [](const auto* a, const auto* b) { return a->load > b->load; });
  double worst = 0, allowed_there = 0;
  int factor = 1;
  for (std::size_t k = 0; k < heaviest.size(); k += std::max<std::size_t>(1, heaviest.size() / kMostSolved)) {
    const Measurement& measurement = *heaviest[k];
    const double allowed = kOfNoise * measurement.sigma;
    if (!(allowed > 0)) continue;
    const auto& X_WB = basePoseAt(placed, measurement);
    const auto found = deflection::discretisationOf(placed.arm, postureOf(measurement, placed.arm, X_WB), allowed);
    if (!(found.tip_error > allowed) || found.tip_error <= worst) continue;
    worst = found.tip_error, allowed_there = allowed, factor = found.factor;
  }
  if (worst == 0) return std::nullopt;
  const auto& unit = checked.units.coordinates;
  std::string sentence = fmt::format(
      "the beams have too few segments for these loads: the tip's discretisation error is about {:.4g} {}, the noise "
      "{:.4g}",
      worst / unit.factor, unit.name, allowed_there / kOfNoise / unit.factor);
  if (factor > 1)
    sentence += "; set `segments: " + std::to_string(factor * deflection::mostSegments(placed.arm)) + "` in each";
  return remarkOf("segments", std::move(sentence));
}

/// Returns a remark if there are too few measurements for their errors to reveal a mistake.
std::optional<MeasurementCheck> fewMeasurements(const CheckedMeasurements& checked) {
  constexpr int kLeastFreedom = 6;
  PlacedArm placed = checked.start;
  FreeChoice named = checked.free;
  std::erase(named.names, "geometry");
  const int free = static_cast<int>(chooseUnknowns(placed, named).list.size());
  const int measured = numbersMeasured(checked.measurements);
  if (measured - free >= kLeastFreedom) return std::nullopt;
  return remarkOf("few-readings", std::to_string(checked.measurements.size()) +
                                      (checked.measurements.size() == 1 ? " reading holds " : " readings hold ") +
                                      std::to_string(measured) + " numbers for the " + std::to_string(free) +
                                      " free parameters: a model error would hardly show; measure more, or free fewer");
}

/// Returns the names of the effects that vary with a condition, such as "base-slip or base-drift"; empty if there are
/// none.
std::string effectsOf(Condition condition) {
  std::string names;
  for (const auto& kind : deflection::effectKinds())
    if (std::ranges::count(conditionsOf(kind), condition) > 0)
      names += (names.empty() ? "" : " or ") + std::string(kind.name);
  return names;
}

}  // namespace

std::vector<MissingColumn> missingColumns(const std::vector<Measurement>& measurements) {
  std::vector<MissingColumn> missing;
  const auto none = [&](auto has) { return std::ranges::none_of(measurements, has); };
  if (none([](const Measurement& m) {
        return std::ranges::any_of(m.approach_directions, [](int s) { return s != 0; });
      }))
    missing.push_back({"<joint>_dir", "with the direction of each joint's last motion, hysteresis could be detected"});
  if (none([](const Measurement& m) { return m.load > 0; }))
    missing.push_back(
        {"load",
         "with several loads, compliance could be distinguished from geometry, and a load's offset be detected"});
  for (const auto& kind : deflection::kConditionKinds)
    if (none([&](const Measurement& m) { return m.conditions.states(kind.condition); }))
      if (const std::string effects = effectsOf(kind.condition); !effects.empty())
        missing.push_back({kind.name, std::string("with the ") + kind.name + ", " + effects + " could be detected"});
  return missing;
}

std::vector<MeasurementCheck> plainChecks(const CheckedMeasurements& checked,
                                          const std::vector<MeasurementCheck>& suspected) {
  std::vector<MeasurementCheck> found;
  for (const auto& look :
       {duplicates, slightlyPastLimits, smallAngles, pulses, heavyLoad, fewSegments, fewMeasurements})
    if (auto check = look(checked);
        check && std::ranges::none_of(suspected, [&](const auto& other) { return other.name == check->name; }))
      found.push_back(std::move(*check));
  return found;
}

std::optional<MeasurementCheck> placesOutOfReach(const CheckedMeasurements& checked, const PlacedArm& found) {
  constexpr double kSlack = 1.02;  // accepted distance relative to the reach: an arm may sag slightly beyond its length
  for (int j = 0; j < checked.start.arm.jointCount(); ++j) {
    const auto& joint = checked.start.arm.joint(j);
    const bool is_endless =
        joint.type == deflection::JointType::kPrismatic && !std::isfinite(joint.upper - joint.lower);
    if (is_endless) return std::nullopt;  // a prismatic joint without limits reaches everywhere
  }
  const double reach = kSlack * deflection::reachOf(checked.start.arm);
  std::vector<std::string> ids;
  for (const auto& measurement : checked.measurements) {
    const auto place = statedPlace(measurement);
    if (!place) continue;
    const auto& X_WB = basePoseAt(found, measurement);
    if (!((*place - X_WB.translation()).norm() <= reach + 5 * measurement.sigma)) ids.push_back(measurement.id);
  }
  if (ids.empty()) return std::nullopt;
  const auto& unit = checked.units.coordinates;
  return remarkOf("out-of-reach",
                  fmt::format("farther from the base than the arm reaches ({:.4g} {}): reading{} {}",
                              reach / kSlack / unit.factor, unit.name, ids.size() > 1 ? "s" : "", listOf(ids)),
                  assumeWithout(ids));
}

std::vector<MeasurementCheck> mistakenHoles(const CheckedMeasurements& checked, const PlacedArm& found) {
  constexpr std::size_t kMostTried = 2000;
  std::vector<MeasurementCheck> mistaken;
  if (!checked.sheet) return mistaken;
  std::size_t tried = 0;
  for (const auto& measurement : checked.measurements) {
    const auto hole = tubesheets::parseTubeName(measurement.point);
    if (!hole || !touchesKnownPoint(measurement) || ++tried > kMostTried) continue;
    const auto tip = predictMeasurement(found, measurement);
    if (!tip.ok || !((tip.value - *measurement.p_W).norm() > checked.sheet->pitch / 2)) continue;
    const tubesheets::Tube* nearest = nullptr;
    double least = checked.sheet->pitch / 2;
    for (const auto& tube : checked.sheet->tubes)
      if (const double d = std::hypot(tube.x - tip.value[0], tube.y - tip.value[1]); d < least)
        least = d, nearest = &tube;
    if (!nearest || (nearest->row == hole->row && nearest->column == hole->column)) continue;
    const std::string name = "R" + std::to_string(nearest->row) + "C" + std::to_string(nearest->column);
    mistaken.push_back(
        {"hole",
         CheckSeverity::kRemark,
         "reading " + measurement.id + " named " + measurement.point + " fits " + name + ": was the hole mistaken?",
         (tip.value - *measurement.p_W).norm(),
         std::hypot(least, tip.value[2]),
         "hole=" + measurement.id + ":" + name,
         {}});
  }
  // If many touches lie at other holes, a wrong name in one measurement is not the cause.
  return mistaken.size() * 3 > tried ? std::vector<MeasurementCheck>{} : mistaken;
}

}  // namespace tubeplan::calibration
