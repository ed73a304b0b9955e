#include "calibration/diagnosis/judgement/posterior.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "calibration/diagnosis/explanations/indistinguishable.hpp"
#include "calibration/diagnosis/judgement/found_members.hpp"
#include "calibration/diagnosis/judgement/remainder.hpp"
#include "calibration/diagnosis/model_selection/model_fit.hpp"

namespace tubeplan::calibration {

namespace {

constexpr std::size_t kMostCompared = 12;  // maximum number of classes that are compared for equal predictions

/// If the sets differ in exactly one cause each, returns these two causes; otherwise nullopt.
std::optional<std::pair<int, int>> difference(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> only_a, only_b;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(only_a));
  std::set_difference(b.begin(), b.end(), a.begin(), a.end(), std::back_inserter(only_b));
  if (only_a.size() != 1 || only_b.size() != 1) return std::nullopt;
  return std::pair{only_a.front(), only_b.front()};
}

/// Adds the name of cause `same` as another name of `cause` in the explanation.
void addName(const DiagnosisWork& work, int cause, int same, Explanation& explanation) {
  const Cause& known = work.cause(cause);
  const Cause& other = work.cause(same);
  for (FoundEffect& found : explanation.effects) {
    if (found.effect != known.effect || (found.at != known.at && known.effects.size() < 2)) continue;
    const std::pair name{other.effect, other.at};
    if (std::ranges::find(found.indistinguishable, name) == found.indistinguishable.end())
      found.indistinguishable.push_back(name);
    return;
  }
}

/// Merges classes that differ in one cause and predict the same over the arm's range.
void joinSame(const DiagnosisWork& work, std::vector<ModelClass>& classes) {
  if (classes.size() < 2) return;
  const RangeViews views(work.basis, work.options.seed);
  std::vector<RangeView> seen;
  for (std::size_t k = 0; k < std::min(classes.size(), kMostCompared); ++k) {
    if (classes[k].probability < kLeastLikely * classes.front().probability) break;
    seen.push_back(views.of(classes[k].explanation));
  }
  std::set<std::size_t> merged;
  for (std::size_t a = 0; a < seen.size(); ++a)
    for (std::size_t b = a + 1; b < seen.size(); ++b) {
      if (merged.contains(a) || merged.contains(b)) continue;
      const auto differing_effect = difference(classes[a].causes, classes[b].causes);
      if (!differing_effect || !areTheSame(seen[a], seen[b])) continue;
      addName(work, differing_effect->first, differing_effect->second, classes[a].explanation);
      mergeClaim(classes[b], classes[a]);
      merged.insert(b);
    }
  std::size_t index = 0;
  std::erase_if(classes, [&](const ModelClass&) { return merged.contains(index++); });
  std::ranges::stable_sort(classes, std::greater{}, &ModelClass::probability);
}

using Names = std::set<std::pair<std::string, std::string>>;

Names namesOf(const Explanation& explanation) {
  Names names;
  for (const FoundEffect& effect : explanation.effects) names.emplace(effect.effect, effect.at);
  return names;
}

/// Explains each likely class by the members found of its collective causes. Other names of an effect stay with it.
/// A class that then has the same explanation as a more probable class is mixed into it.
void nameFoundMembers(const DiagnosisWork& work, std::vector<ModelClass>& classes) {
  std::vector<ModelClass> named;
  const double most = classes.empty() ? 0 : classes.front().probability;
  for (ModelClass& model_class : classes) {
    if (model_class.probability >= kLeastLikely * most) {
      Explanation found = explanationByFoundMembers(work, *model_class.model);
      for (FoundEffect& effect : found.effects)
        for (const FoundEffect& joined : model_class.explanation.effects)
          if (joined.effect == effect.effect && joined.at == effect.at)
            effect.indistinguishable = joined.indistinguishable;
      model_class.explanation = std::move(found);
    }
    const auto same = std::ranges::find_if(
        named, [&](const ModelClass& other) { return namesOf(other.explanation) == namesOf(model_class.explanation); });
    if (same == named.end())
      named.push_back(std::move(model_class));
    else
      mergeClaim(model_class, *same);
  }
  std::ranges::stable_sort(named, std::greater{}, &ModelClass::probability);
  classes = std::move(named);
}

bool containsAll(const std::vector<int>& all, const std::vector<int>& some) {
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

/// Returns the causes of a class. For an effect at every joint, the causes with this effect at a single joint are
/// included.
std::set<int> impliedBy(const DiagnosisWork& work, const std::vector<int>& causes) {
  std::set<int> implied(causes.begin(), causes.end());
  for (const int collective : causes) {
    if (work.cause(collective).effects.size() < 2) continue;
    for (int single = 0; single < static_cast<int>(work.causes.causes.size()); ++single)
      if (work.cause(single).effects.size() == 1 && overlap(work.cause(single), work.cause(collective)))
        implied.insert(single);
  }
  return implied;
}

/// Returns the causes that are certain if anything is missing, except those implied by another certain cause.
std::vector<int> certainCauses(const DiagnosisWork& work, const Posterior& posterior) {
  std::map<int, double> probability;
  for (const auto* classes : {&posterior.classes, &posterior.others})
    for (const ModelClass& model_class : *classes)
      for (const int cause : impliedBy(work, model_class.causes)) probability[cause] += model_class.probability;
  std::vector<int> certain;
  for (const auto& [cause, p] : probability)
    if (p >= work.options.required_probability * (1 - posterior.nothing)) certain.push_back(cause);
  std::vector<int> own;
  for (const int cause : certain)
    if (std::ranges::none_of(certain, [&](int collective) {
          return collective != cause && work.cause(collective).effects.size() > 1 &&
                 impliedBy(work, {collective}).contains(cause);
        }))
      own.push_back(cause);
  return own;
}

/// Returns the fitted model with exactly these causes: a competing model, or the first model that contains these
/// causes, with its other causes removed.
CompetingModel competingModelOf(const DiagnosisWork& work, const std::vector<int>& causes) {
  const CompetingModel* found = nullptr;
  for (const CompetingModel& model : work.models) {
    const bool is_exact = causesOf(model.terms) == causes;
    if (is_exact || (!found && containsAll(causesOf(model.terms), causes))) found = &model;
    if (is_exact) break;
  }
  if (!found) return {};
  CompetingModel model = *found;
  if (causesOf(model.terms) == causes && model.is_fitted) return model;
  std::erase_if(model.terms,
                [&](const ModelTerm& term) { return std::ranges::find(causes, term.cause) == causes.end(); });
  model.sizes.resize(0);
  model.fit = {};
  fitModel(work, model);
  return model;
}

void findCertain(const DiagnosisWork& work, Posterior& posterior) {
  const auto causes = certainCauses(work, posterior);
  if (causes.empty()) return;
  posterior.certain_model = competingModelOf(work, causes);
  if (!posterior.certain_model.hasFit()) return;
  ModelClass& certain = posterior.certain;
  certain.causes = causes;
  certain.explanation = explanationByFoundMembers(work, posterior.certain_model);
  double alone = 0;
  for (const auto* classes : {&posterior.classes, &posterior.others})
    for (const ModelClass& model_class : *classes) {
      const auto implied = impliedBy(work, model_class.causes);
      if (!std::ranges::all_of(causes, [&](int cause) { return implied.contains(cause); })) continue;
      certain.probability += model_class.probability;
      if (model_class.causes == causes) alone += model_class.probability * (1 - model_class.remainder_probability);
    }
  certain.remainder_probability = certain.probability > 0 ? 1 - alone / certain.probability : 1;
  certain.explanation.probability = certain.probability;
  certain.explanation.remainder_probability = certain.remainder_probability;
}

}  // namespace

Posterior posteriorOf(const DiagnosisWork& work) {
  Posterior posterior{};
  const bool repeats = samePostureBy(work, {}).isSignificant();
  std::map<std::vector<int>, ModelClass> classes;
  for (const Claim& claim : claimsOf(work)) {
    if (claim.causes.empty()) {
      const double scatter = claim.probability * claim.scatter_probability;
      (repeats ? posterior.unknown : posterior.scatter) += scatter;
      posterior.nothing += std::max(0., claim.probability * (1 - claim.remainder_probability) - scatter);
      posterior.unknown += claim.probability * claim.remainder_probability;
      continue;
    }
    ModelClass& model_class = classes[claim.causes];
    mergeClaim(claim, model_class);
    const CompetingModel* model = claim.model;
    if (model && model->hasFit() && (!model_class.model || model->logWeight() > model_class.model->logWeight()))
      model_class.model = model;
  }
  for (auto& [causes, model_class] : classes) {
    model_class.causes = causes;
    if (model_class.model) model_class.explanation = model_class.model->fit;
    (model_class.model ? posterior.classes : posterior.others).push_back(std::move(model_class));
  }
  std::ranges::stable_sort(posterior.classes, std::greater{}, &ModelClass::probability);
  joinSame(work, posterior.classes);
  nameFoundMembers(work, posterior.classes);
  for (ModelClass& model_class : posterior.classes) {
    model_class.explanation.probability = model_class.probability;
    model_class.explanation.remainder_probability = model_class.remainder_probability;
  }
  findCertain(work, posterior);
  return posterior;
}

}  // namespace tubeplan::calibration
