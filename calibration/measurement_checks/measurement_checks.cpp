#include "calibration/measurement_checks/measurement_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "calibration/measurement_checks/clock.hpp"
#include "calibration/measurement_checks/gravity_direction.hpp"
#include "calibration/measurement_checks/misread_rows.hpp"
#include "calibration/measurement_checks/mistake_search.hpp"
#include "calibration/measurement_checks/mistake_trials.hpp"
#include "calibration/measurement_checks/plain_checks.hpp"
#include "calibration/measurement_checks/rounded_joints.hpp"
#include "calibration/measurement_checks/stale_joints.hpp"
#include "calibration/measurement_checks/stuck_joints.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

namespace {

/// Correction to the unit of sigma with which chi-square per degree of freedom is closest to 1.
struct SigmaUnit {
  Correction correction;
  double chi2_per_freedom = kNoFigure;
};
std::optional<SigmaUnit> likeliestSigma(const MistakeTrials& trials, bool is_smaller) {
  const CheckedMeasurements& checked = trials.checked();
  std::optional<SigmaUnit> best;
  const auto& units = checked.units;
  for (const auto& unit : units.sigmas) {
    if (unit.name == units.sigma.name || (unit.factor < units.sigma.factor) != is_smaller) continue;
    auto correction = findMistakeKind("sigma")->correction(checked, unit.name);
    if (!correction) continue;
    const Trial trial = trials.tried(*correction, TrialDepth::kOpen);
    if (!trial.ok || !(trial.chi2_per_freedom > 0)) continue;
    if (!best || std::abs(std::log(trial.chi2_per_freedom)) < std::abs(std::log(best->chi2_per_freedom)))
      best = SigmaUnit{std::move(*correction), trial.chi2_per_freedom};
  }
  return best;
}

void checkSigma(const MistakeTrials& trials, std::vector<MeasurementCheck>& checks) {
  const CheckedMeasurements& checked = trials.checked();
  const Trial& as_is = trials.asIs();
  // Chi-square per degree of freedom may differ from 1 by this factor, because stated sigmas are usually rough.
  constexpr double kAgrees = 5;
  // Smallest credible sigma relative to the arm's reach: interferometers measure a machine to 0.5 um in a metre.
  constexpr double kFinest = 2e-7;
  constexpr std::size_t kFew = 6;
  std::vector<double> sigmas;
  for (const auto& measurement : checked.measurements) sigmas.push_back(measurement.sigma);
  const double sigma = median(std::move(sigmas));
  const bool is_large = checked.measurements.size() >= kFew && as_is.chi2_per_freedom < kFarBelowNoise;
  const auto agreesWith = [](double chi2) { return std::abs(std::log(chi2)) < std::log(kAgrees); };
  const bool is_fine = sigma < kFinest * trials.reach() && !agreesWith(as_is.chi2_per_freedom);
  if (!is_large && !is_fine) return;
  const auto likeliest = likeliestSigma(trials, is_large);
  const bool agrees = likeliest && agreesWith(likeliest->chi2_per_freedom);
  const std::string text =
      is_large
          ? fmt::format("the readings agree {:.2g} times better than their stated noise",
                        1 / std::sqrt(std::max(as_is.chi2_per_freedom, 1e-30)))
          : fmt::format("the stated noise ({:.2g} {}) is smaller than that of any instrument for an arm of this size",
                        sigma / checked.units.sigma.factor, checked.units.sigma.name);
  MeasurementCheck check = remarkOf("sigma", text);
  if (agrees && is_large) check.severity = CheckSeverity::kMistake;
  if (agrees || (is_fine && likeliest)) {
    check.sentence += ": " + likeliest->correction.sentence;
    check.assume = "sigma=" + likeliest->correction.value;
  }
  checks.push_back(std::move(check));
}

/// Returns true if the fitted base is too far from its nominal pose for any mounting error. Returns false for a cell
/// without a tube sheet, where the nominal place is only a start value.
bool isElsewhere(const MistakeTrials& trials) {
  constexpr double kTurned = 0.8;  // smallest rotation of a base that is turned instead of merely misaligned [rad]
  const Trial& as_is = trials.asIs();
  return trials.checked().sheet && trials.hasPlaces() &&
         (as_is.base_shift > trials.reach() ||
          (as_is.base_turn > kTurned && as_is.base_shift > kFarShift * trials.reach()));
}

/// Adds a remark if the base is far from its nominal place, or if a miscounted row or column of holes explains its
/// displacement.
void checkBase(const MistakeTrials& trials, std::vector<MeasurementCheck>& checks) {
  const CheckedMeasurements& checked = trials.checked();
  const Trial& as_is = trials.asIs();
  constexpr double kNearlyAPitch = 0.7, kBack = 3;
  const bool is_far = trials.isBaseFar(as_is);
  const bool is_pitches =
      checked.sheet && trials.hasPlaces() && as_is.base_shift > kNearlyAPitch * checked.sheet->pitch;
  if (!is_far && !is_pitches) return;
  const auto is_said = [](const MeasurementCheck& check) {
    return check.sentence.find("nominal place") != std::string::npos;
  };
  if (std::ranges::any_of(checks, is_said)) return;
  MeasurementCheck check =
      remarkOf("base-from-nominal", "the best-fitting base is " + baseText(trials) + " from its nominal place");
  if (is_pitches)
    for (const auto& value : findMistakeKind("holes")->values(checked))
      if (const auto correction = findMistakeKind("holes")->correction(checked, value)) {
        const Trial trial = trials.tried(*correction, TrialDepth::kDrawn);
        if (!trial.ok || trial.base_shift * kBack > as_is.base_shift) continue;
        check.sentence += ": were the holes counted from another row or column?";
        check.assume = "holes=" + value;
        break;
      }
  if (check.assume.empty() && isElsewhere(trials)) {
    check.severity = CheckSeverity::kMistake;
    check.sentence += ", farther than any mounting: are these readings of another cell? If not, correct its base";
  }
  checks.push_back(std::move(check));
}

/// Returns true if, with the mistake corrected, the remaining error is at most a few times the noise and the base is
/// near its nominal place.
bool leavesNothing(const MistakeTrials& trials, const FoundMistake& mistake) {
  constexpr double kAboveNoise = 5;
  return mistake.drawn.error < kAboveNoise * trials.noise({}) && !trials.isBaseFar(mistake.drawn);
}

/// Returns the finding that fits the measurements better: the mistake or the gravity direction. Both may fit, because
/// exchanged axes rotate an unknown base and, with it, the direction of gravity in the base frame. In this case,
/// returns the finding whose base is closer to nominal, and mentions the other one in its sentence.
MeasurementCheck likelier(const MistakeTrials& trials, FoundMistake mistake, FoundMistake gravity) {
  constexpr double kClearly = 2;
  if (mistake.drawn.error > kClearly * gravity.drawn.error) return std::move(gravity.check);
  if (gravity.drawn.error > kClearly * mistake.drawn.error) return std::move(mistake.check);
  const bool is_gravity = trials.isBaseFar(mistake.drawn) && !trials.isBaseFar(gravity.drawn);
  if (is_gravity) gravity.check.equally.push_back(mistake.check.assume);
  FoundMistake &named = is_gravity ? gravity : mistake, &other = is_gravity ? mistake : gravity;
  constexpr double kDegrees = 180 / std::numbers::pi;
  named.check.sentence += fmt::format(
      ", with the base turned by {:.2g} deg from its nominal place; or {}, with the base turned by {:.2g} deg",
      named.drawn.base_turn * kDegrees, other.check.sentence, other.drawn.base_turn * kDegrees);
  return std::move(named.check);
}

/// Returns the likeliest mistake: a common mistake in the measurements, reversed twists or another direction of
/// gravity; nullopt if none is found.
std::optional<MeasurementCheck> mistakeOrGravity(const MistakeTrials& trials) {
  auto found = findMistake(trials);
  const bool is_mistake = found && found->check.severity == CheckSeverity::kMistake;
  if (is_mistake && leavesNothing(trials, *found)) return std::move(found->check);
  if (!is_mistake)
    if (auto twist = negatedTwists(trials)) return twist;
  auto gravity = wrongGravityDirection(trials);
  if (is_mistake && gravity) return likelier(trials, std::move(*found), std::move(*gravity));
  if (gravity) return std::move(gravity->check);
  return found ? std::optional(std::move(found->check)) : std::nullopt;
}

}  // namespace

MeasurementChecks checkMeasurements(const CheckedMeasurements& checked, const CheckOptions& options) {
  MeasurementChecks result;
  result.missing = missingColumns(checked.measurements);
  if (checked.measurements.empty()) return result;
  const MistakeTrials trials(checked, options);
  const Trial& as_is = trials.asIs();
  result.base_shift = as_is.base_shift;
  result.base_turn = as_is.base_turn;
  if (as_is.ok) checkSigma(trials, result.checks);
  auto mistake = standardRows(trials);
  if (!mistake) mistake = mistakeOrGravity(trials);
  if (mistake) result.checks.push_back(std::move(*mistake));
  if (as_is.ok && !firstMistake(result)) {
    checkBase(trials, result.checks);
    for (auto& stale : staleMeasurements(checked, as_is.placed)) result.checks.push_back(std::move(stale));
    for (auto& stuck : stuckJoints(checked, as_is.placed)) result.checks.push_back(std::move(stuck));
    if (auto rounded = roundedJoints(trials)) result.checks.push_back(std::move(*rounded));
    if (auto far = placesOutOfReach(checked, as_is.placed)) result.checks.push_back(std::move(*far));
    for (auto& hole : mistakenHoles(checked, as_is.placed)) result.checks.push_back(std::move(hole));
  }
  for (auto& jump : clockJumps(checked)) result.checks.push_back(std::move(jump));
  for (auto& plain : plainChecks(checked, result.checks)) result.checks.push_back(std::move(plain));
  std::ranges::stable_sort(result.checks, {}, &MeasurementCheck::severity);
  return result;
}

const MeasurementCheck* firstMistake(const MeasurementChecks& checks) {
  for (const auto& check : checks.checks)
    if (check.severity == CheckSeverity::kMistake) return &check;
  return nullptr;
}

}  // namespace tubeplan::calibration
