#include "calibration/measurement_checks/mistake_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "calibration/measurement_checks/rotation_search.hpp"
#include "calibration/measurement_checks/shift_search.hpp"
#include "calibration/measurement_checks/step_search.hpp"
#include "calibration/measurement_checks/suspect_judgement.hpp"
#include "calibration/measurement_checks/zero_search.hpp"

namespace tubeplan::calibration {

namespace {

constexpr std::size_t kFinalists = 8;
constexpr double kLimitSlack = 0.05;    // accepted distance beyond a joint's limit [rad or m]
constexpr double kShareOutside = 0.02;  // accepted fraction of corrected measurements that are beyond joint limits

class MistakeSearch {
 public:
  explicit MistakeSearch(const MistakeTrials& trials) : trials_(trials), judgement_(trials) {}

  [[nodiscard]] std::optional<FoundMistake> find() const {
    if (!judgement_.needsMistakeSearch() && !judgement_.needsStepSearch()) return std::nullopt;
    auto suspects = judgement_.needsMistakeSearch() ? examined(screened()) : std::vector<Suspect>{};
    const auto tried = suspects;
    std::erase_if(suspects, [&](const Suspect& suspect) {
      return !judgement_.explainsError(suspect) && !judgement_.explainsBase(suspect);
    });
    if (std::ranges::none_of(suspects, SuspectJudgement::isAtNoise))
      addExplaining(examined(withSteps(tried, judgement_.hasRemainingError(suspects))), suspects);
    if (judgement_.needsCombinedSearch(suspects)) addExplaining(examined(screenedTogether()), suspects);
    if (suspects.empty()) return std::nullopt;
    std::ranges::stable_sort(suspects, std::greater{},
                             [&](const Suspect& suspect) { return judgement_.merit(suspect); });
    return checkOf(std::move(suspects));
  }

 private:
  /// Returns the suspects with fits of all open parameters, except suspects that cannot be fitted.
  std::vector<Suspect> examined(std::vector<Suspect> suspects) const {
    for (auto& suspect : suspects) {
      const double held_error = suspect.drawn.error;
      suspect.drawn = trials_.tried(suspect.correction, TrialDepth::kDrawn);
      suspect.drawn.held_error = held_error;
      suspect.open = trials_.tried(suspect.correction, TrialDepth::kOpen);
    }
    std::erase_if(suspects, [](const Suspect& suspect) { return !suspect.open.ok; });
    return suspects;
  }

  /// Adds the hypotheses of `several` to `suspects` that explain the error and need each of their mistakes for it.
  void addExplaining(std::vector<Suspect> several, std::vector<Suspect>& suspects) const {
    for (Suspect& suspect : several)
      if (judgement_.explainsError(suspect) && judgement_.isAllNeeded(suspect)) suspects.push_back(std::move(suspect));
  }

  /// Returns suspects with a step: in the measurements as stated and, if `with_others` is true, also in the
  /// measurements corrected for each of `suspects`.
  std::vector<Suspect> withSteps(const std::vector<Suspect>& suspects, bool with_others) const {
    std::vector<Suspect> begun;
    const auto add = [&](const JoinedCorrections& parts, const Correction& before, const Trial& open) {
      for (Correction& step : likelySteps(trials_, before, open)) {
        Suspect suspect{parts, {}, {}, {}};
        suspect.parts.push_back(std::move(step));
        suspect.correction = joined(suspect.parts);
        suspect.drawn = trials_.tried(suspect.correction, TrialDepth::kHeld);
        begun.push_back(std::move(suspect));
      }
    };
    if (trials_.asIs().ok) add({}, {}, trials_.asIs());
    if (with_others)
      for (const Suspect& suspect : suspects)
        if (!suspect.correction.parts_setups) add(suspect.parts, suspect.correction, suspect.open);
    return begun;
  }

  /// Returns the first suspect as a finding, together with the values of `--assume` for other suspects that explain the
  /// measurements equally well.
  FoundMistake checkOf(std::vector<Suspect> suspects) const {
    Suspect& best = suspects.front();
    MeasurementCheck check;
    check.name = best.correction.mistake;
    check.assume = best.correction.mistake + "=" + best.correction.value;
    settleSigma(best, check);
    const bool is_of_error = judgement_.explainsError(best);
    const bool is_effect = is_of_error && judgement_.isEffectAsLikely(best);
    check.severity = is_of_error && !is_effect && judgement_.isDetermined(best.correction) ? CheckSeverity::kMistake
                                                                                           : CheckSeverity::kRemark;
    check.sentence =
        best.correction.sentence + (best.correction.change_sigma ? "; the unit of sigma with it" : "") +
        (is_of_error ? "" : ", or the base stands far from its nominal place (" + baseText(trials_) + ")") +
        (is_effect ? "; or an effect of the arm, which explains the readings as well" : "");
    stateErrors(best, check);
    for (std::size_t k = 1; k < suspects.size(); ++k)
      if (judgement_.isAsGood(suspects[k], best))
        check.equally.push_back(suspects[k].correction.mistake + "=" + suspects[k].correction.value);
    return {std::move(check), std::move(best.drawn)};
  }

  /// Decides whether the sigmas are corrected together with the coordinates if both columns state the same unit. The
  /// sigmas are kept if the errors agree better with the stated ones. Errors far below a sigma refute it, whereas
  /// errors far above it may be due to the model.
  void settleSigma(Suspect& best, MeasurementCheck& check) const {
    if (!best.correction.change_sigma) return;
    Correction unscaled_sigma = best.correction;
    unscaled_sigma.change_sigma = nullptr;
    const Trial trial = trials_.tried(unscaled_sigma, TrialDepth::kOpen);
    const auto offBy = [](const Trial& of) {
      return std::pair(of.chi2_per_freedom < kFarBelowNoise, std::abs(std::log(of.chi2_per_freedom)));
    };
    if (!trial.ok || !(offBy(trial) < offBy(best.open))) return;
    const auto kind = std::ranges::find_if(mistakeKinds(), [](const auto& other) { return other.settles_sigma; });
    check.assume += fmt::format(",{}={}", kind->name, trials_.checked().units.sigma.name);
    best.correction = std::move(unscaled_sigma);
    best.open = trial;
  }

  /// Returns the number of measurements with at least one joint beyond its limits.
  [[nodiscard]] std::size_t countOutside(const std::vector<Measurement>& measurements) const {
    const auto& arm = trials_.checked().start.arm;
    return static_cast<std::size_t>(std::ranges::count_if(measurements, [&](const Measurement& measurement) {
      for (int j = 0; j < measurement.q.size(); ++j)
        if (measurement.q[j] < arm.joint(j).lower - kLimitSlack || measurement.q[j] > arm.joint(j).upper + kLimitSlack)
          return true;
      return false;
    }));
  }

  /// Returns true if nearly all corrected measurements are within the joint limits. Also returns true if the correction
  /// does not concern a joint's zero and does not move further measurements beyond the limits.
  [[nodiscard]] bool isWithinLimits(const Correction& correction) const {
    auto measurements = trials_.pool().measurements;
    correction.apply(measurements);
    if (measurements.empty()) return false;
    const std::size_t outside = countOutside(measurements);
    return static_cast<double>(outside) <= kShareOutside * static_cast<double>(measurements.size()) ||
           (correction.zeros_of.empty() && outside <= countOutside(trials_.pool().measurements));
  }

  std::vector<Suspect> screened() const {
    std::vector<Suspect> suspects;
    for (const auto& kind : mistakeKinds())
      for (const auto& value : kind.values(trials_.checked())) {
        throwIfStopped(trials_.options().stop);
        auto correction = kind.correction(trials_.checked(), value);
        if (correction) screen({std::move(*correction)}, suspects);
      }
    return foremost(std::move(suspects));
  }

  std::vector<Suspect> screenedTogether() const {
    std::vector<Suspect> suspects;
    for (const auto& likely : {likelyTogether(trials_), likelyRotationMistakes(trials_), likelyRowShifts(trials_)})
      for (const auto& parts : likely) {
        throwIfStopped(trials_.options().stop);
        screen(parts, suspects);
      }
    return foremost(std::move(suspects));
  }

  /// Fits a hypothesis relative to the drawing and adds it to `suspects`, unless it is invalid or already among them.
  void screen(JoinedCorrections tried, std::vector<Suspect>& suspects) const {
    auto parts = withZerosFound(trials_, std::move(tried));
    if (!parts) return;
    Correction correction = joined(*parts);
    if (!isWithinLimits(correction)) return;
    if (!correction.zeros_of.empty() && std::ranges::any_of(suspects, [&](const Suspect& other) {
          return other.correction.mistake == correction.mistake && other.correction.value == correction.value;
        }))
      return;
    Trial trial = trials_.tried(correction, TrialDepth::kHeld);
    if (trial.ok) suspects.push_back({std::move(*parts), std::move(correction), std::move(trial), {}});
  }

  /// Returns the suspects that fit best relative to the drawing.
  std::vector<Suspect> foremost(std::vector<Suspect> suspects) const {
    const std::size_t kept = std::min(kFinalists, suspects.size());
    std::partial_sort(suspects.begin(), suspects.begin() + static_cast<std::ptrdiff_t>(kept), suspects.end(),
                      [&](const Suspect& a, const Suspect& b) {
                        return a.drawn.lack_of_fit - gainByShrinking(a.drawn) <
                               b.drawn.lack_of_fit - gainByShrinking(b.drawn);
                      });
    suspects.resize(kept);
    return suspects;
  }

  double gainByShrinking(const Trial& trial) const {
    return -3 * static_cast<double>(trials_.pool().counted_quickly.size()) * std::log(trials_.shrinkage(trial));
  }

  /// States in `check` the errors before and after the correction, at the depth of fit where they differ most: relative
  /// to the drawing, with the tip as drawn, or with all open parameters free. If only some measurements are corrected,
  /// the error over all measurements is considered as well, because the nine tenths with the smallest errors may
  /// exclude the corrected measurements. A fit with as many parameters as measured values has no meaningful error, and
  /// errors below the noise are not stated.
  void stateErrors(const Suspect& best, MeasurementCheck& check) const {
    struct Fall {
      TrialDepth depth;
      double as_is, corrected;
    };
    const Trial& as_is = trials_.asIs();
    std::vector<Fall> falls = {{TrialDepth::kDrawn, as_is.error, best.drawn.error},
                               {TrialDepth::kHeld, as_is.held_error, best.drawn.held_error},
                               {TrialDepth::kOpen, as_is.open_error, best.open.error}};
    if (best.correction.is_of_part) falls.push_back({TrialDepth::kOpen, as_is.whole_error, best.open.whole_error});
    std::erase_if(falls, [&](const Fall& fall) { return trials_.freedom(best.correction, fall.depth) <= 0; });
    if (falls.empty()) return;
    for (Fall& fall : falls) {
      fall.as_is = std::max(fall.as_is, trials_.noise({}));
      fall.corrected = std::max(fall.corrected, trials_.noise(best.correction));
    }
    const Fall& most =
        *std::ranges::max_element(falls, {}, [](const Fall& fall) { return fall.as_is / fall.corrected; });
    if (as_is.ok) check.error_as_is = most.as_is;
    check.error_if_corrected = most.corrected;
  }

  const MistakeTrials& trials_;
  SuspectJudgement judgement_;
};

}  // namespace

std::optional<FoundMistake> findMistake(const MistakeTrials& trials) { return MistakeSearch(trials).find(); }

std::string baseText(const MistakeTrials& trials) {
  const CheckedMeasurements& checked = trials.checked();
  const Trial& trial = trials.asIs();
  const auto& length = checked.units.coordinates;
  const bool has_pitch = checked.sheet && checked.sheet->pitch > 0;
  return fmt::format("{:.3g} {}{} and {:.2g} deg", trial.base_shift / length.factor, length.name,
                     has_pitch ? fmt::format(" ({:.1f} pitches)", trial.base_shift / checked.sheet->pitch) : "",
                     trial.base_turn * 180 / std::numbers::pi);
}

}  // namespace tubeplan::calibration
