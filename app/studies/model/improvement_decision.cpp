#include "app/studies/model/improvement_decision.hpp"

#include <algorithm>
#include <cmath>

#include "deflection/effects/effect.hpp"

namespace tubeplan::app {

namespace {

using calibration::Diagnosis, calibration::Explanation, calibration::Verdict;

constexpr double kWorthIt = 0.95;  // an uncertain cause must reduce the error to less than this fraction
// A certain cause must not raise the error of the farthest poses by more than this factor.
constexpr double kNoWorse = 1.05;

/// Returns the sum of the squares of the effects' parameters, relative to the largest plausible ones.
double squaredSizeOf(const Explanation& explanation) {
  double sum = 0;
  for (const auto& found : explanation.effects) {
    if (!found.frees.empty()) continue;
    const auto& parameters = deflection::numbersOf(found.fitted);
    for (std::size_t v = 0; v < parameters.size(); ++v)
      if (!parameters[v].is_shape)
        sum += std::pow((found.fitted.values[v] - parameters[v].neutral) / parameters[v].plausible, 2);
  }
  return sum;
}

/// Returns true if both explanations consist of the same effects, whatever their places.
bool haveSameEffects(const Explanation& a, const Explanation& b) {
  return std::ranges::is_permutation(a.effects, b.effects, {}, &calibration::FoundEffect::effect,
                                     &calibration::FoundEffect::effect);
}

/// Returns the explanation with the smallest error at the farthest poses among those that `isWorthIt` accepts; null if
/// there is none. The explanations are in order of probability: a less probable explanation replaces the best so far
/// only if its error is at least 5 % lower. Of the same effects at other places that carry as far, the smallest ones
/// are returned: a joint with a small lever needs a large effect, which changes most what was not measured.
template <class IsWorthIt>
const Explanation* bestCarried(const std::vector<Explanation>& explanations, const IsWorthIt& isWorthIt) {
  const Explanation* best = nullptr;
  for (const auto& explanation : explanations)
    if (std::isfinite(explanation.farthest.rms) && isWorthIt(explanation) &&
        (!best || explanation.farthest.rms < kWorthIt * best->farthest.rms))
      best = &explanation;
  if (!best) return best;
  const double farthest = best->farthest.rms / kWorthIt;
  for (const auto& explanation : explanations)
    if (explanation.farthest.rms <= farthest && isWorthIt(explanation) && haveSameEffects(explanation, *best) &&
        squaredSizeOf(explanation) < squaredSizeOf(*best))
      best = &explanation;
  return best;
}

/// Decides between equally good explanations. Adds the best one if the difference of their predictions does not exceed
/// its reduction of the held-out error. Otherwise adds the causes common to all, if these reduce that error.
ImprovementDecision amongEquals(const Diagnosis& diagnosis) {
  double widest = 0;
  for (const auto& alternative : diagnosis.alternatives)
    if (std::isfinite(alternative.distance_from_first)) widest = std::max(widest, alternative.distance_from_first);
  const Explanation* best = bestCarried(diagnosis.alternatives, [](const Explanation&) { return true; });
  const double gain = best ? diagnosis.heldout_before.rms - best->heldout.rms : 0;
  if (best && widest <= gain)
    return {best, ImprovementEnd::kNotRun, ImprovementReason::kAlternativesClose, widest, gain};
  if (diagnosis.agreed && diagnosis.agreed->heldout.rms < diagnosis.heldout_before.rms &&
      diagnosis.agreed->farthest.rms <= kNoWorse * diagnosis.farthest_before.rms)
    return {&*diagnosis.agreed, ImprovementEnd::kNotRun, ImprovementReason::kCertainInAll};
  return {nullptr, ImprovementEnd::kAmbiguous, ImprovementReason::kAlternativesDiffer, widest, std::max(0., gain)};
}

/// Decides if no cause is certain. A cause is added only if it lowers the error of measurements excluded from its fit,
/// both for the held-out folds and for the farthest poses.
ImprovementDecision amongUnsure(const Diagnosis& diagnosis) {
  const Explanation* best = bestCarried(diagnosis.closest, [&](const Explanation& explanation) {
    return explanation.heldout.rms < kWorthIt * diagnosis.heldout_before.rms &&
           explanation.farthest.rms < kWorthIt * diagnosis.farthest_before.rms;
  });
  if (!best) return {nullptr, ImprovementEnd::kNothingCertain, ImprovementReason::kNoneLower};
  return {best, ImprovementEnd::kNotRun, ImprovementReason::kUnsureButLower};
}

ImprovementDecision onCertain(const Diagnosis& diagnosis) {
  const Explanation& first = diagnosis.alternatives.front();
  if (first.farthest.rms > kNoWorse * diagnosis.farthest_before.rms)
    return {nullptr, ImprovementEnd::kDoesNotCarryOver, ImprovementReason::kFarthestWorse, first.farthest.rms,
            diagnosis.farthest_before.rms};
  return {&first, ImprovementEnd::kNotRun, ImprovementReason::kCertain};
}

}  // namespace

ImprovementDecision improvementDecision(const Diagnosis& diagnosis) {
  switch (diagnosis.verdict) {
    case Verdict::kAdequate:
      return {nullptr, ImprovementEnd::kAdequate, ImprovementReason::kNothingMissing};
    case Verdict::kExplained:
    case Verdict::kPartlyExplained:
      return onCertain(diagnosis);
    case Verdict::kAmbiguous:
      return amongEquals(diagnosis);
    case Verdict::kUnexplained:
      if (diagnosis.isScatterAlone())
        return {nullptr, ImprovementEnd::kNothingCertain, ImprovementReason::kScatter, diagnosis.remainder.size};
      return amongUnsure(diagnosis);
    default:
      return {nullptr, ImprovementEnd::kInconclusive, ImprovementReason::kNoVerdict};
  }
}

}  // namespace tubeplan::app
