#include "calibration/diagnosis/judgement/decision.hpp"

#include <algorithm>

namespace tubeplan::calibration {

namespace {

constexpr std::size_t kMostAlternatives = 8;
// Alternatives are listed until they reach this fraction of the probability of all classes.
constexpr double kCredible = 0.95;
constexpr double kRemains = 0.5;

/// Returns the classes except those that only add causes to a more probable class; the probability of an omitted class
/// is added to this more probable class.
std::vector<ModelClass> withoutUnsureAdditions(const Posterior& posterior) {
  std::vector<ModelClass> kept, all = posterior.classes;
  all.insert(all.end(), posterior.others.begin(), posterior.others.end());
  for (const ModelClass& model_class : all) {
    const auto part = std::ranges::find_if(kept, [&](const ModelClass& k) {
      return std::includes(model_class.causes.begin(), model_class.causes.end(), k.causes.begin(), k.causes.end());
    });
    if (part == kept.end()) {
      if (model_class.model) kept.push_back(model_class);
      continue;
    }
    // The class without the additional cause leaves its effect unexplained.
    Claim further = model_class;
    further.remainder_probability = 1;
    further.scatter_probability = 0;
    mergeClaim(further, *part);
  }
  std::ranges::stable_sort(kept, std::greater{}, &ModelClass::probability);
  return kept;
}

}  // namespace

void decide(const DiagnosisOptions& options, const Posterior& posterior, Diagnosis& result) {
  result.nothing_probability = posterior.nothing;
  result.unknown_probability = posterior.unknown;
  result.scatter_probability = posterior.scatter;
  if (posterior.nothing > 1 - options.required_probability) {
    result.verdict = posterior.nothing >= options.nothing ? Verdict::kAdequate : Verdict::kInconclusive;
    return;
  }
  const double missing = 1 - posterior.nothing;
  const auto classes = withoutUnsureAdditions(posterior);
  double named = 0, remains = 0;
  for (const ModelClass& model_class : classes) {
    named += model_class.probability / missing;
    remains += model_class.probability / missing * model_class.remainder_probability;
  }
  if (classes.empty() || named < options.likely || remains > kRemains * named) {
    const bool has_certain = !posterior.certain.causes.empty();
    result.verdict = has_certain ? Verdict::kPartlyExplained : Verdict::kUnexplained;
    if (has_certain) result.alternatives = {posterior.certain.explanation};
    return;
  }
  const bool is_single = classes.front().probability / missing >= options.required_probability;
  double together = 0;
  for (const ModelClass& model_class : classes) {
    const bool is_needed =
        together < kCredible * named && model_class.probability > kLeastLikely * classes.front().probability;
    if (result.alternatives.size() == (is_single ? 1 : kMostAlternatives) || !is_needed) break;
    result.alternatives.push_back(model_class.explanation);
    together += model_class.probability / missing;
  }
  const bool is_ambiguous = result.alternatives.size() > 1 || named < options.required_probability;
  // If a single class competes only with an unknown effect, the second best class is named as well.
  if (is_ambiguous && result.alternatives.size() == 1 && classes.size() > 1)
    result.alternatives.push_back(classes[1].explanation);
  if (is_ambiguous)
    result.verdict = Verdict::kAmbiguous;
  else
    result.verdict = classes.front().scatter_probability > kRemains ? Verdict::kPartlyExplained : Verdict::kExplained;
  if (result.alternatives.size() > 1 && !posterior.certain.causes.empty() &&
      posterior.certain.causes.size() < classes.front().causes.size())
    result.agreed = posterior.certain.explanation;
}

}  // namespace tubeplan::calibration
