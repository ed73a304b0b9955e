#include "calibration/diagnosis/judgement/found_members.hpp"

#include <algorithm>

#include "calibration/diagnosis/model_selection/leading_models.hpp"

namespace tubeplan::calibration {

namespace {

// Significance below which a member may be left out; the evidence decides whether it is [standard deviations].
constexpr double kDoubtful = 4;
// Fall of the log evidence that is accepted for naming fewer members.
constexpr double kWorthNaming = 1;

/// Returns the effects of the explanation that are doubtful members of a collective cause, the least significant first.
std::vector<const FoundEffect*> doubtfulMembers(const DiagnosisWork& work, const CompetingModel& model) {
  std::vector<const FoundEffect*> members;
  for (const FoundEffect& effect : model.fit.effects) {
    const bool is_member = std::ranges::any_of(model.terms, [&](const ModelTerm& term) {
      const Cause& cause = work.cause(term.cause);
      return cause.effects.size() > 1 && cause.effect == effect.effect;
    });
    if (is_member && significanceOf(effect) < kDoubtful) members.push_back(&effect);
  }
  std::ranges::stable_sort(members, {}, [](const FoundEffect* effect) { return significanceOf(*effect); });
  return members;
}

std::vector<deflection::Effect> effectsWithout(const Explanation& explanation,
                                               const std::vector<const FoundEffect*>& left_out) {
  std::vector<deflection::Effect> effects;
  for (const FoundEffect& effect : explanation.effects)
    if (std::ranges::find(left_out, &effect) == left_out.end()) effects.push_back(effect.fitted);
  return effects;
}

}  // namespace

Explanation explanationByFoundMembers(const DiagnosisWork& work, const CompetingModel& model) {
  const bool frees =
      std::ranges::any_of(model.fit.effects, [](const FoundEffect& effect) { return !effect.frees.empty(); });
  std::vector<const FoundEffect*> left_out;
  if (!frees) left_out = doubtfulMembers(work, model);
  for (; !left_out.empty(); left_out.pop_back()) {
    const CompetingModel smaller = fittedModelOf(work, effectsWithout(model.fit, left_out));
    if (smaller.hasFit() && smaller.log_evidence >= model.log_evidence - kWorthNaming) return smaller.fit;
  }
  return model.fit;
}

}  // namespace tubeplan::calibration
