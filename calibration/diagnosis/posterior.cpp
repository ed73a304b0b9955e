#include "calibration/diagnosis/posterior.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "calibration/diagnosis/indistinguishable.hpp"
#include "calibration/diagnosis/model_fit.hpp"
#include "calibration/diagnosis/same_posture.hpp"
#include "calibration/estimation/fit.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::VectorXd;

namespace {

constexpr std::size_t kMostCompared = 12;  // classes that are held to be the same or not
constexpr std::size_t kMostAlternatives = 8;
constexpr double kCredible = 0.95;     // of what is missing, that the alternatives hold together
constexpr double kLeastLikely = 0.02;  // of the best alternative's probability
constexpr double kRemains = 0.5;
constexpr double kNeverSeen = 1e-6;  // noise sigmas that a cause of the largest usual size shows

/// What one model says, or what it says if one of its terms is but a likeness of something unknown.
struct Claim {
  std::vector<int> causes;
  double probability = 0;
  double remainder_probability = 0, scatter_probability = 0;
  const CompetingModel* model = nullptr;  ///< none of a likeness
};

/// A model that could not be fitted explains nothing.
bool hasFit(const CompetingModel& model) { return model.is_fitted && std::isfinite(model.log_evidence); }

/// What the linearisation about the baseline promises too much: by the models with causes that were fitted.
double lossByFit(const DiagnosisWork& work) {
  std::vector<double> losses;
  for (const CompetingModel& model : work.models)
    if (hasFit(model) && !model.terms.empty()) losses.push_back(-model.gain_by_fit);
  return losses.empty() ? 0 : std::max(0., median(std::move(losses)));
}

/// All that the models claim, its probabilities one together. Those that were not fitted would have lost as others did.
std::vector<Claim> claimsOf(const DiagnosisWork& work) {
  std::vector<Claim> claims;
  std::vector<double> logs;
  const double loss = lossByFit(work);
  for (const CompetingModel& model : work.models) {
    claims.push_back({causesOf(model.terms), 0, model.discrepancy_probability, model.scatter_probability, &model});
    logs.push_back(model.logWeight() - (model.is_fitted ? 0 : loss));
    for (const Likeness& likeness : hasFit(model) ? model.likenesses : std::vector<Likeness>{}) {
      auto others = model.terms;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(likeness.term));
      claims.push_back({causesOf(others), 0, 1, 0, nullptr});
      logs.push_back(likeness.log_weight);
    }
  }
  const double most = *std::max_element(logs.begin(), logs.end());
  double total = 0;
  for (const double log : logs) total += std::exp(log - most);
  for (std::size_t k = 0; k < claims.size(); ++k) claims[k].probability = std::exp(logs[k] - most) / total;
  return claims;
}

/// The one cause that each has and the other has not; nothing where they differ in more.
std::optional<std::pair<int, int>> difference(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> only_a, only_b;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(only_a));
  std::set_difference(b.begin(), b.end(), a.begin(), a.end(), std::back_inserter(only_b));
  if (only_a.size() != 1 || only_b.size() != 1) return std::nullopt;
  return std::pair{only_a.front(), only_b.front()};
}

/// Puts the other name of a cause beside the name that its class has.
void addName(const DiagnosisWork& work, int cause, int same, Explanation& explanation) {
  const Cause& known = work.cause(cause);
  const Cause& other = work.cause(same);
  for (FoundEffect& found : explanation.effects) {
    if (found.effect != known.effect || (found.at != known.at && known.effects.size() < 2)) continue;
    const std::pair name{other.effect, other.at};
    if (std::find(found.also.begin(), found.also.end(), name) == found.also.end()) found.also.push_back(name);
    return;
  }
}

/// Probabilities of one class counted to another.
void mixIn(const ModelClass& one, ModelClass& to) {
  const double both = to.probability + one.probability;
  if (!(both > 0)) return;
  const auto mixed = [&](double a, double b) { return (to.probability * a + one.probability * b) / both; };
  to.remainder_probability = mixed(to.remainder_probability, one.remainder_probability);
  to.scatter_probability = mixed(to.scatter_probability, one.scatter_probability);
  to.probability = both;
}

/// Joins classes that differ in one cause and predict the same all over the arm's range.
void joinSame(const DiagnosisWork& work, std::vector<ModelClass>& classes) {
  if (classes.size() < 2) return;
  const RangeViews views(work.basis, work.options.seed);
  std::vector<RangeView> seen;
  for (std::size_t k = 0; k < std::min(classes.size(), kMostCompared); ++k) {
    if (classes[k].probability < kLeastLikely * classes.front().probability) break;
    seen.push_back(views.of(classes[k].explanation));
  }
  std::set<std::size_t> gone;
  for (std::size_t a = 0; a < seen.size(); ++a)
    for (std::size_t b = a + 1; b < seen.size(); ++b) {
      if (gone.contains(a) || gone.contains(b)) continue;
      const auto apart = difference(classes[a].causes, classes[b].causes);
      if (!apart || !areTheSame(seen[a], seen[b])) continue;
      addName(work, apart->first, apart->second, classes[a].explanation);
      mixIn(classes[b], classes[a]);
      gone.insert(b);
    }
  std::size_t index = 0;
  std::erase_if(classes, [&](const ModelClass&) { return gone.contains(index++); });
  std::stable_sort(classes.begin(), classes.end(),
                   [](const ModelClass& a, const ModelClass& b) { return a.probability > b.probability; });
}

bool holds(const std::vector<int>& all, const std::vector<int>& some) {
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

/// Causes beyond those of a more probable class are not sure: they count to it.
std::vector<ModelClass> withoutUnsureAdditions(const Posterior& posterior) {
  std::vector<ModelClass> kept, all = posterior.classes;
  all.insert(all.end(), posterior.others.begin(), posterior.others.end());
  for (const ModelClass& one : all) {
    const auto part =
        std::find_if(kept.begin(), kept.end(), [&](const ModelClass& k) { return holds(one.causes, k.causes); });
    if (part == kept.end()) {
      if (one.model) kept.push_back(one);
      continue;
    }
    // What the further cause would explain is a remainder to the class without it.
    ModelClass further = one;
    further.remainder_probability = 1;
    further.scatter_probability = 0;
    mixIn(further, *part);
  }
  std::stable_sort(kept.begin(), kept.end(),
                   [](const ModelClass& a, const ModelClass& b) { return a.probability > b.probability; });
  return kept;
}

/// Causes that a class says: its own, and of one at all joints alike that at each joint.
std::set<int> impliedBy(const DiagnosisWork& work, const std::vector<int>& causes) {
  std::set<int> implied(causes.begin(), causes.end());
  for (const int all : causes) {
    if (work.cause(all).effects.size() < 2) continue;
    for (int one = 0; one < static_cast<int>(work.causes.causes.size()); ++one)
      if (work.cause(one).effects.size() == 1 && overlap(work.cause(one), work.cause(all))) implied.insert(one);
  }
  return implied;
}

/// The causes that most of what is missing agrees on, without those that others of them imply.
std::vector<int> sureCauses(const DiagnosisWork& work, const Posterior& posterior) {
  std::map<int, double> probability;
  for (const auto* classes : {&posterior.classes, &posterior.others})
    for (const ModelClass& one : *classes)
      for (const int cause : impliedBy(work, one.causes)) probability[cause] += one.probability;
  std::vector<int> sure;
  for (const auto& [cause, p] : probability)
    if (p >= work.options.sure * (1 - posterior.nothing)) sure.push_back(cause);
  std::vector<int> own;
  for (const int cause : sure)
    if (std::none_of(sure.begin(), sure.end(), [&](int all) {
          return all != cause && work.cause(all).effects.size() > 1 && impliedBy(work, {all}).contains(cause);
        }))
      own.push_back(cause);
  return own;
}

/// The model of these causes alone: one that competes, or the first that holds them without its other causes.
CompetingModel competingModelOf(const DiagnosisWork& work, const std::vector<int>& causes) {
  const CompetingModel* found = nullptr;
  for (const CompetingModel& model : work.models) {
    const bool is_exact = causesOf(model.terms) == causes;
    if (is_exact || (!found && holds(causesOf(model.terms), causes))) found = &model;
    if (is_exact) break;
  }
  if (!found) return {};
  CompetingModel model = *found;
  if (causesOf(model.terms) == causes && model.is_fitted) return model;
  std::erase_if(model.terms, [&](const ModelTerm& term) {
    return std::find(causes.begin(), causes.end(), term.cause) == causes.end();
  });
  model.sizes.resize(0);
  model.fit = {};
  fitModel(work, model);
  return model;
}

void findSure(const DiagnosisWork& work, Posterior& posterior) {
  const auto causes = sureCauses(work, posterior);
  if (causes.empty()) return;
  posterior.sure_model = competingModelOf(work, causes);
  if (!posterior.sure_model.is_fitted || !std::isfinite(posterior.sure_model.log_evidence)) return;
  ModelClass& sure = posterior.sure;
  sure.causes = causes;
  sure.explanation = posterior.sure_model.fit;
  double alone = 0;
  for (const auto* classes : {&posterior.classes, &posterior.others})
    for (const ModelClass& one : *classes) {
      const auto implied = impliedBy(work, one.causes);
      if (!std::all_of(causes.begin(), causes.end(), [&](int cause) { return implied.contains(cause); })) continue;
      sure.probability += one.probability;
      if (one.causes == causes) alone += one.probability * (1 - one.remainder_probability);
    }
  sure.remainder_probability = sure.probability > 0 ? 1 - alone / sure.probability : 1;
  sure.explanation.probability = sure.probability;
  sure.explanation.remainder_probability = sure.remainder_probability;
}

/// Of the errors that a model leaves; those of the baseline where it has no causes, or no fit.
SamePosture samePostureBy(const DiagnosisWork& work, const CompetingModel& model) {
  const DiagnosisBasis& basis = work.basis;
  if (model.terms.empty() || !hasFit(model)) return judgeSamePosture(basis.readings, basis.weights, basis.residual.r);
  const auto residual = whitenedResidual(model.fit.fitted, {}, basis.readings, basis.weights, {}, false);
  return residual.ok ? judgeSamePosture(basis.readings, basis.weights, residual.r) : SamePosture{};
}

/// What the evidence of a cause must gain to be sure (19 to 1), its prior and its freedom paid for.
double logLeastGain(const Cause& cause, double visibility) {
  const double occam = std::log(std::max(1., 0.5 * visibility));
  const double odds = std::log(0.5 / 0.35) - std::log(std::max(1e-12, cause.prior)) + std::log(19.);
  return std::max(0., odds + occam + std::log(static_cast<double>(cause.levels.size())));
}

/// The effects of a term at these sizes.
std::vector<deflection::Effect> effectsAt(const PlacedArm& placed, const ModelTerm& term,
                                          const std::vector<Unknown>& numbers, const VectorXd& sizes,
                                          std::size_t before) {
  std::vector<Unknown> chosen;
  for (const int number : term.numbers) chosen.push_back(numbers[static_cast<std::size_t>(number)]);
  VectorXd x(sizes.size());
  for (std::size_t k = 0; k < chosen.size(); ++k)
    x[static_cast<Index>(k)] =
        std::clamp(sizes[static_cast<Index>(k)] * chosen[k].typical, chosen[k].lower, chosen[k].upper);
  const auto all = applied(placed, chosen, x).arm.effects;
  return {all.begin() + static_cast<std::ptrdiff_t>(before), all.end()};
}

}  // namespace

Posterior posteriorOf(const DiagnosisWork& work) {
  Posterior posterior{};
  const bool repeats = samePostureBy(work, {}).isSure();
  std::map<std::vector<int>, ModelClass> classes;
  for (const Claim& claim : claimsOf(work)) {
    if (claim.causes.empty()) {
      const double scatter = claim.probability * claim.scatter_probability;
      (repeats ? posterior.unknown : posterior.scatter) += scatter;
      posterior.nothing += std::max(0., claim.probability * (1 - claim.remainder_probability) - scatter);
      posterior.unknown += claim.probability * claim.remainder_probability;
      continue;
    }
    ModelClass& one = classes[claim.causes];
    ModelClass more;
    more.probability = claim.probability;
    more.remainder_probability = claim.remainder_probability;
    more.scatter_probability = claim.scatter_probability;
    mixIn(more, one);
    const CompetingModel* model = claim.model;
    if (model && hasFit(*model) && (!one.model || model->logWeight() > one.model->logWeight())) one.model = model;
  }
  for (auto& [causes, one] : classes) {
    one.causes = causes;
    if (one.model) one.explanation = one.model->fit;
    (one.model ? posterior.classes : posterior.others).push_back(std::move(one));
  }
  std::stable_sort(posterior.classes.begin(), posterior.classes.end(),
                   [](const ModelClass& a, const ModelClass& b) { return a.probability > b.probability; });
  joinSame(work, posterior.classes);
  for (ModelClass& one : posterior.classes) {
    one.explanation.probability = one.probability;
    one.explanation.remainder_probability = one.remainder_probability;
  }
  findSure(work, posterior);
  return posterior;
}

void decide(const DiagnosisOptions& options, const Posterior& posterior, Diagnosis& result) {
  result.nothing_probability = posterior.nothing;
  result.unknown_probability = posterior.unknown;
  result.scatter_probability = posterior.scatter;
  if (posterior.nothing > 1 - options.sure) {
    result.verdict = posterior.nothing >= options.nothing ? Verdict::kAdequate : Verdict::kInconclusive;
    return;
  }
  const double missing = 1 - posterior.nothing;
  const auto classes = withoutUnsureAdditions(posterior);
  double named = 0, remains = 0;
  for (const ModelClass& one : classes) {
    named += one.probability / missing;
    remains += one.probability / missing * one.remainder_probability;
  }
  if (classes.empty() || named < options.likely || remains > kRemains * named) {
    const bool is_sure = !posterior.sure.causes.empty();
    result.verdict = is_sure ? Verdict::kPartlyExplained : Verdict::kUnexplained;
    if (is_sure) result.alternatives = {posterior.sure.explanation};
    return;
  }
  const bool is_single = classes.front().probability / missing >= options.sure;
  double together = 0;
  for (const ModelClass& one : classes) {
    const bool is_needed = together < kCredible * named && one.probability > kLeastLikely * classes.front().probability;
    if (result.alternatives.size() == (is_single ? 1 : kMostAlternatives) || !is_needed) break;
    result.alternatives.push_back(one.explanation);
    together += one.probability / missing;
  }
  if (result.alternatives.size() > 1 || named < options.sure)
    result.verdict = Verdict::kAmbiguous;
  else
    result.verdict = classes.front().scatter_probability > kRemains ? Verdict::kPartlyExplained : Verdict::kExplained;
  if (result.alternatives.size() > 1 && !posterior.sure.causes.empty() &&
      posterior.sure.causes.size() < classes.front().causes.size())
    result.agreed = posterior.sure.explanation;
}

void rankCauses(const DiagnosisWork& work, Diagnosis& result) {
  std::map<int, double> probability;
  std::map<int, const CompetingModel*> alone;
  for (const Claim& claim : claimsOf(work)) {
    for (const int cause : claim.causes) probability[cause] += claim.probability;
    if (claim.model && claim.causes.size() == 1) alone[claim.causes.front()] = claim.model;
  }
  const NoiseHypothesis& noise = work.noise.back();
  for (const auto& [index, model] : alone) {
    const Cause& cause = work.cause(index);
    const ModelTerm& term = model->terms.front();
    std::vector<int> columns;
    for (const int number : term.numbers)
      columns.push_back(work.signatures->columnsOf(index, term.level)[static_cast<std::size_t>(number)]);
    RankedEffect entry;
    entry.effect = cause.effect;
    entry.at = cause.at;
    entry.probability = std::min(1., probability[index]);
    entry.fall = work.noise.front().evidence->fall(columns);
    entry.p_value = chiSquareTail(noise.evidence->fall(columns), static_cast<double>(columns.size()));
    for (const int column : columns)
      entry.kept_fraction = std::max(entry.kept_fraction, noise.evidence->keptShare(column));
    Index largest = 0;
    if (model->sizes.size() == 0) continue;
    (model->sizes.array().abs() / model->sigma.array().max(1e-300)).maxCoeff(&largest);
    PlacedArm placed = work.basis.fitted;
    const auto numbers = placeCause(placed, cause, cause.levels[static_cast<std::size_t>(term.level)]);
    const Unknown& number = numbers[static_cast<std::size_t>(term.numbers[static_cast<std::size_t>(largest)])];
    entry.effects = effectsAt(placed, term, numbers, model->sizes, work.basis.fitted.arm.effects.size());
    const double x = model->sizes[largest] * number.typical;
    const std::size_t dot = number.name.rfind('.');
    entry.size = {cause.frees.empty() ? number.name.substr(dot + 1) : number.name, number.quantity, valueAt(number, x),
                  model->sigma[largest] * number.typical * std::abs(slopeAt(number, x))};
    result.ranking.push_back(std::move(entry));
  }
  std::stable_sort(result.ranking.begin(), result.ranking.end(), [](const RankedEffect& a, const RankedEffect& b) {
    return a.probability != b.probability ? a.probability > b.probability : a.fall > b.fall;
  });
}

void listDetectable(const DiagnosisWork& work, Diagnosis& result) {
  const NoiseHypothesis& noise = work.noise.back();
  for (int index = 0; index < static_cast<int>(work.causes.causes.size()); ++index) {
    const Cause& cause = work.cause(index);
    if (!cause.frees.empty() || cause.effects.size() != 1) continue;
    const int middle = static_cast<int>(cause.levels.size() / 2);
    const double visibility = noise.evidence->visibility(work.signatures->columnsOf(index, middle).front());
    const double sigmas = std::sqrt(2 * logLeastGain(cause, visibility)) + 0.84;
    PlacedArm placed = work.basis.fitted;
    const Unknown number = placeCause(placed, cause, cause.levels[static_cast<std::size_t>(middle)]).front();
    // What moves no reading but for rounding shows at no size.
    const double units = visibility > kNeverSeen ? sigmas / visibility : std::numeric_limits<double>::infinity();
    result.detectable.push_back({cause.effect, cause.at, number.name.substr(number.name.rfind('.') + 1),
                                 number.quantity, units * number.typical, units > 1});
  }
}

Remainder remainderOf(const DiagnosisWork& work, const CompetingModel& model) {
  Remainder remainder;
  remainder.probability = model.discrepancy_probability + model.scatter_probability;
  const double noise_floor = noiseFloor(work.basis.readings, work.basis.weights);
  const double scatter = std::sqrt(3.) * model.model_error;
  if (model.remainder.size() == 0) {  // what follows nothing is all there is
    remainder.floor = noise_floor;
    if (scatter > 0) remainder.size = scatter;
    if (const SamePosture same = samePostureBy(work, model); same.isSure())
      remainder.follows.emplace_back("posture", same.share);
    return remainder;
  }
  remainder.floor = std::hypot(noise_floor, scatter);
  const NoiseHypothesis& noise = model.more_noise_probability > 0.5 ? work.noise.back() : work.noise.front();
  double squares = 0;
  for (std::size_t k = 0; k < work.basis.readings.size(); ++k) {
    const auto& whitener = noise.weights.whitener[k];
    const VectorXd whitened = model.remainder.segment(noise.weights.first_row[k], whitener.rows());
    squares += (whitener.inverse() * whitened).squaredNorm();
  }
  remainder.size = std::sqrt(squares / static_cast<double>(work.basis.readings.size()));
  std::map<std::string, double> shares;
  double whole = 0;
  for (std::size_t t = 0; t < work.discrepancy->terms().size(); ++t) {
    const auto& term = work.discrepancy->terms()[t];
    const double weight = model.remainder_terms[static_cast<Index>(t)];
    shares[term.follows] += weight * weight * term.share;
    whole += weight * weight * term.share;
  }
  for (const auto& [follows, share] : shares)
    if (share > 0.05 * whole) remainder.follows.emplace_back(follows, share / whole);
  std::stable_sort(remainder.follows.begin(), remainder.follows.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return remainder;
}

}  // namespace tubeplan::calibration
