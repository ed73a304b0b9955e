#include "calibration/measurement_checks/suspect_judgement.hpp"

#include <algorithm>
#include <limits>

#include "calibration/measurements/measurement_problems.hpp"

namespace tubeplan::calibration {

namespace {

constexpr double kLeastFall = 3;    // smallest factor by which a mistake must reduce the error relative to the drawing
constexpr double kFitted = 4. / 3;  // factor by which kLeastFall grows for fitted numbers that leave an error
constexpr double kOdds = 14;        // required log odds: log of a million
// Factor of error reduction that a fit of the drawing's open parameters cannot plausibly achieve.
constexpr double kDrastic = 8;
constexpr double kAsGood = 3;  // log odds within which another mistake explains the measurements equally well
constexpr double kAsGoodError =
    1.5;  // ratio of errors within which another mistake explains the measurements equally well
constexpr double kNoisePerRow = 0.6;  // lack of fit per row due to noise alone
constexpr double kFits = 0.05;        // largest error of measurements without a mistake, relative to the reach
// Error, relative to the reach, above which several mistakes are tried after one is corrected.
constexpr double kLeftOver = 0.001;
constexpr double kBent = 0.005;  // error with the nominal tip that no sag explains, relative to the reach
// Contraction of the measured positions above which their error is judged relative to their spread.
constexpr double kContracts = 1.5;
constexpr double kMostAtNoise = 2;  // largest chi-square per degree of freedom due to noise alone

/// Returns true if a correction has fitted parameters. Part of the smaller error may then be due to the fit.
bool hasNumbers(const Correction& correction) {
  return correction.frees_base || correction.parts_setups || correction.numbers_fitted > 0;
}

/// Returns true if every parameter of the effect is of a size that is possible on a real machine.
bool isOfRealMachines(const deflection::Effect& effect) {
  constexpr double kImpossible = 10;  // multiple of the largest plausible magnitude
  const auto& parameters = deflection::numbersOf(effect);
  for (std::size_t v = 0; v < effect.values.size(); ++v)
    if (std::abs(effect.values[v] - parameters[v].neutral) > kImpossible * parameters[v].plausible) return false;
  return true;
}

/// Returns every effect of the catalogue at every place where the arm can have it, except effects with a parameter that
/// has to be scanned.
std::vector<deflection::Effect> magnitudesAlone(const deflection::Arm& arm) {
  std::vector<deflection::Effect> effects;
  for (const auto& kind : deflection::effectKinds()) {
    const bool is_scanned = std::ranges::any_of(kind.parameters, &deflection::EffectParameter::is_shape);
    if (kind.odds <= 0 || is_scanned || kind.at == deflection::PlaceRule::kSetup) continue;
    for (const std::string& at : deflection::placeTexts(arm, kind)) {
      const auto made = deflection::makeEffect(arm, kind.name, at);
      if (made.status == deflection::EffectStatus::kMade) effects.push_back(made.effect);
    }
  }
  return effects;
}

}  // namespace

bool SuspectJudgement::hasRemainingError(const std::vector<Suspect>& suspects) const {
  double least_error = trials_.asIs().ok ? trials_.asIs().open_error : std::numeric_limits<double>::infinity();
  for (const auto& suspect : suspects) least_error = std::min(least_error, suspect.open.error);
  return least_error > std::max(kLeftOver * trials_.reach(), kLeastFall * trials_.noise({}));
}

bool SuspectJudgement::isBent(const Suspect& suspect) const {
  return suspect.drawn.held_error > kDrastic * suspect.open.error &&
         suspect.drawn.held_error > std::max(kBent * trials_.reach(), kLeastFall * trials_.noise(suspect.correction));
}

bool SuspectJudgement::needsCombinedSearch(const std::vector<Suspect>& suspects) const {
  const auto isWanting = [&](const Suspect& suspect) {
    const bool is_settled = suspect.correction.against > 0 && isAtNoise(suspect);  // a step that leaves only noise
    return !is_settled && (trials_.isBaseFar(suspect.drawn) || isBent(suspect));
  };
  return hasRemainingError(suspects) || (!suspects.empty() && std::ranges::all_of(suspects, isWanting));
}

bool SuspectJudgement::isAllNeeded(const Suspect& suspect) const {
  for (std::size_t k = 0; suspect.parts.size() > 1 && k < suspect.parts.size(); ++k) {
    auto parts = suspect.parts;
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
    const Correction others = joined(parts);
    const Trial open = trials_.tried(others, TrialDepth::kOpen);
    if (!open.ok) continue;
    const Trial held = trials_.tried(others, TrialDepth::kHeld);
    const bool falls = suspect.parts[k].against > 0 || held.error >= kLeastFall * suspect.drawn.held_error ||
                       open.error >= kLeastFall * suspect.open.error || restoresNominalBase(held, suspect.drawn);
    if (!falls || trials_.gain(suspect.open) - trials_.gain(open) - suspect.parts[k].against < kOdds) return false;
  }
  return true;
}

bool SuspectJudgement::needsMistakeSearch() const {
  if (!trials_.asIs().ok) return true;
  const double noise = trials_.noise({});
  if (trials_.asIs().whole_error > kFits * trials_.reach()) return true;  // some of the measurements contain a mistake
  const bool is_bent =
      // The measurements fit only if the arm's dimensions depart implausibly far from the drawing.
      trials_.asIs().held_error > kDrastic * trials_.asIs().open_error;
  return trials_.isBaseFar(trials_.asIs()) ||
         (trials_.asIs().held_error > kLeastFall * noise && (isLackOfFit() || is_bent));
}

bool SuspectJudgement::needsStepSearch() const {
  constexpr double kMoreThanNoise = 1.5;  // chi-square per degree of freedom that noise alone hardly exceeds
  return isLackOfFit() || trials_.asIs().chi2_per_freedom > kMoreThanNoise;
}

bool SuspectJudgement::isLackOfFit() const {
  double rows = 0;
  for (const auto& measurement : trials_.checked().measurements)
    if (trials_.pool().counted.contains(measurement.id)) rows += rowsOf(measurement);
  return trials_.asIs().lack_of_fit - kNoisePerRow * rows > kOdds;
}

bool SuspectJudgement::isDetermined(const Correction& correction) const {
  constexpr int kLeastFreedom = 6;
  auto measurements = trials_.pool().measurements;
  const std::size_t all = measurements.size();
  correction.apply(measurements);
  if (!hasNumbers(correction) && measurements.size() == all) return true;
  const auto start = trials_.startOf(correction);
  const auto bases = std::ranges::count(start.base_poses, false, &BasePose::is_known);
  return numbersMeasured(measurements) - 6 * static_cast<int>(bases) - correction.numbers_fitted >= kLeastFreedom;
}

bool SuspectJudgement::explainsError(const Suspect& suspect) const {
  if (std::min(suspect.drawn.error, suspect.open.error) >= kFits * trials_.reach()) return false;
  if (!trials_.asIs().ok) return suspect.drawn.error < kFits * trials_.reach();
  // A correction that contracts tips or measured positions lowers their error even if it is wrong.
  const double shrinks = trials_.shrinkage(suspect.drawn), contracts = trials_.contraction(suspect.correction);
  const auto falls = [&](double as_is, double corrected) { return as_is >= kLeastFall * corrected * shrinks; };
  const auto fallsAnywhere = [&](double by) {
    return falls(trials_.asIs().error, by * suspect.drawn.error) ||
           falls(trials_.asIs().held_error, by * suspect.drawn.held_error) ||
           falls(trials_.asIs().open_error, by * suspect.open.error);
  };
  if (contracts > kContracts && !fallsAnywhere(contracts) &&
      !falls(trials_.asIs().whole_error, contracts * suspect.open.whole_error))
    return false;
  // A step that leaves only noise, and that no creep explains (step_search.hpp), need not reduce the error by
  // kLeastFall.
  if (suspect.correction.against > 0 && isAtNoise(suspect) && gainOf(suspect) >= kOdds) return true;
  // A wrong base affects all measurements, so freeing it must also reduce the error over all of them, not only over the
  // nine tenths with the smallest errors.
  if (suspect.correction.frees_base && !falls(trials_.asIs().whole_error, suspect.open.whole_error)) return false;
  if (!hasNumbers(suspect.correction) && trials_.gain(suspect.open) > 0 &&
      trials_.asIs().held_error >= kDrastic * suspect.drawn.held_error * shrinks)
    return true;
  // A correction of some measurements must make them fit about as well as the others, i.e. `whole_error` must be close
  // to `error`; otherwise it is the wrong correction.
  if (suspect.correction.is_of_part && trials_.gain(suspect.open) >= kOdds &&
      trials_.asIs().whole_error >= kDrastic * suspect.open.whole_error * shrinks &&
      suspect.open.whole_error < kLeastFall * suspect.open.error)
    return true;
  // Numbers fitted to measurements that still do not agree may have absorbed an effect instead.
  const bool is_left = std::min(suspect.drawn.error, suspect.open.error) > kLeftOver * trials_.reach();
  return gainOf(suspect) >= kOdds && fallsAnywhere(is_left && hasNumbers(suspect.correction) ? kFitted : 1);
}

bool SuspectJudgement::restoresNominalBase(const Trial& before, const Trial& after) const {
  constexpr double kBack = 4;  // smallest ratio of the distances before and after
  const double far_shift = kFarShift * trials_.reach();
  const bool turns_back = before.base_turn > kFarTurn && before.base_turn >= kBack * after.base_turn;
  const bool shifts_back = before.base_shift > far_shift && before.base_shift >= kBack * after.base_shift;
  return trials_.hasPlaces() && (turns_back || shifts_back) && after.base_turn < kFarTurn &&
         after.base_shift < far_shift;
}

bool SuspectJudgement::explainsBase(const Suspect& suspect) const {
  constexpr double kHarm = 1.5;
  return trials_.asIs().ok && restoresNominalBase(trials_.asIs(), suspect.drawn) &&
         suspect.drawn.error <= kHarm * trials_.asIs().error && trials_.gain(suspect.open) >= kOdds;
}

double SuspectJudgement::gainOf(const Suspect& suspect) const {
  return trials_.gain(suspect.open) - suspect.correction.against;
}
double SuspectJudgement::merit(const Suspect& suspect) const {
  return gainOf(suspect) - kOdds * static_cast<double>(suspect.parts.size() - 1);
}

bool SuspectJudgement::isEffectAsLikely(const Suspect& suspect) const {
  constexpr std::size_t kFinalists = 4;
  if (suspect.parts.size() > 1) return false;
  std::vector<std::pair<double, deflection::Effect>> effects;  // with their errors relative to the drawing
  for (const auto& effect : magnitudesAlone(trials_.checked().start.arm)) {
    throwIfStopped(trials_.options().stop);
    const Trial drawn = trials_.triedWith(effect, TrialDepth::kDrawn);
    if (drawn.ok) effects.emplace_back(drawn.error, effect);
  }
  std::ranges::stable_sort(effects, {}, [](const auto& tried) { return tried.first; });
  effects.resize(std::min(kFinalists, effects.size()));
  return std::ranges::any_of(effects, [&](const auto& tried) {
    const Trial open = trials_.triedWith(tried.second, TrialDepth::kOpen);
    return open.ok && isOfRealMachines(open.placed.arm.effects.back()) &&
           trials_.gain(open) > gainOf(suspect) - kAsGood;
  });
}

bool SuspectJudgement::isAtNoise(const Suspect& suspect) { return suspect.open.chi2_per_freedom < kMostAtNoise; }

bool SuspectJudgement::isAsGood(const Suspect& other, const Suspect& best) const {
  return other.parts.size() <= best.parts.size() && gainOf(other) > gainOf(best) - kAsGood &&
         other.drawn.error < kAsGoodError * best.drawn.error;
}

}  // namespace tubeplan::calibration
