#include "calibration/diagnosis/model_selection/leading_models.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "calibration/diagnosis/model_selection/model_evidence.hpp"
#include "calibration/diagnosis/model_selection/model_fit.hpp"
#include "calibration/diagnosis/model_selection/model_search.hpp"
#include "calibration/diagnosis/model_selection/model_terms.hpp"
#include "calibration/diagnosis/model_selection/noise_hypotheses.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::VectorXd;

namespace {

constexpr std::size_t kFitsAtOnce = 6;  // number of models that are fitted in parallel
constexpr int kManyRows = 20000;        // number of rows above which fewer leading models are fitted
// Models are fitted if their log weight is within this distance of the best.
constexpr double kLeaderWindow = 8;
// Additional window, as a fraction of the best model's gain in log weight over the model with nothing missing. The
// error of linear evidence grows with this gain.
constexpr double kLeaderShare = 0.075;

/// Returns the terms that have at least one significant parameter in the fit.
std::vector<ModelTerm> significantTerms(const CompetingModel& model) {
  std::vector<ModelTerm> significant;
  Index first = 0;
  for (const ModelTerm& term : model.terms) {
    const auto count = static_cast<Index>(term.numbers.size());
    const auto sigmas = model.sizes.segment(first, count).cwiseQuotient(model.sigma.segment(first, count));
    if ((sigmas.array().abs() >= kFoundSigmas).any()) significant.push_back(term);
    first += count;
  }
  return significant;
}

/// Returns the best term of each cause, given the best terms of the other causes.
std::vector<ModelTerm> bestTerms(const DiagnosisWork& work, const std::vector<int>& causes) {
  CompetingModel seed = work.models.front();
  std::vector<ModelTerm> terms;
  for (int pass = 0; pass < 2; ++pass)
    for (const int cause : causes) {
      seed.terms = terms;
      std::erase_if(seed.terms, [&](const ModelTerm& term) { return term.cause == cause; });
      seed.log_share = logShareOf(work, seed.terms);
      terms = bestExtension(work, seed, cause, true).terms;
    }
  return terms;
}

/// Returns the parameter values of the terms, read from these effects, in units of Unknown::typical; empty if all
/// values are neutral.
VectorXd sizesIn(const DiagnosisWork& work, const std::vector<ModelTerm>& terms,
                 const std::vector<deflection::Effect>& effects) {
  std::vector<double> sizes;
  for (const ModelTerm& term : terms) {
    const Cause& cause = work.cause(term.cause);
    const auto same =
        std::ranges::find_if(effects, [&](const auto& effect) { return areOne(effect, cause.effects.front()); });
    PlacedArm placed = work.basis.fitted;
    const auto numbers = placeCause(placed, cause, cause.levels[static_cast<std::size_t>(term.level)]);
    for (const int number : term.numbers) {
      const Unknown& unknown = numbers[static_cast<std::size_t>(number)];
      const double value = same->values[static_cast<std::size_t>(unknown.path.value)];
      sizes.push_back(variableAt(unknown, value) / unknown.typical);
    }
  }
  const VectorXd all = Eigen::Map<const VectorXd>(sizes.data(), static_cast<Index>(sizes.size()));
  return all.isZero(0) ? VectorXd() : all;
}

/// Returns an unfitted variant of the best fitted model, or null. One variant omits the causes without a significant
/// parameter: linear evidence may add a cause to compensate for a coarse time or knee of another one. The other variant
/// has all parameters of its causes: linear evidence may omit a parameter that a larger error masks.
CompetingModel* unfittedVariant(DiagnosisWork& work) {
  const CompetingModel& best = work.models.front();
  if (best.terms.empty() || !best.hasFit()) return nullptr;
  for (const auto& terms : {significantTerms(best), fullTerms(work, best.terms)}) {
    if (terms.empty() || terms == best.terms) continue;
    const auto same =
        std::ranges::find_if(work.models, [&](const CompetingModel& model) { return model.terms == terms; });
    if (same != work.models.end() && same->is_fitted) continue;
    if (same != work.models.end()) return &*same;
    work.models.push_back(weigh(work, terms, logShareOf(work, terms)));
    return &work.models.back();
  }
  return nullptr;
}

/// Fits the model with nothing missing, then the leading models until no unfitted model is close to the best fitted
/// one.
void fitNearest(DiagnosisWork& work) {
  auto& models = work.models;
  CompetingModel& of_nothing =
      *std::ranges::find_if(models, [](const CompetingModel& model) { return model.terms.empty(); });
  const double nothing = of_nothing.logWeight();
  fitModel(work, of_nothing);
  // With very many measurements, each fit takes seconds, but fewer fits suffice, because models differ by far more than
  // the error of linear evidence.
  const bool are_many = work.noise.front().weights.rows > kManyRows;
  const auto limit = static_cast<std::size_t>(are_many ? work.options.most_leaders / 3 : work.options.most_leaders);
  const std::size_t most = are_many ? limit : 2 * limit;
  for (std::size_t fitted = 0;;) {
    sortByWeight(models);
    CompetingModel* variant = unfittedVariant(work);
    const double best = models.front().logWeight();
    const double window = leaderWindow(best, nothing);
    std::vector<CompetingModel*> next;
    if (variant) next.push_back(variant);
    for (std::size_t k = 0; fitted < most && k < std::min(limit, models.size()) && next.size() < kFitsAtOnce; ++k)
      if (!models[k].is_fitted && models[k].logWeight() > best - window && &models[k] != variant)
        next.push_back(&models[k]);
    if (next.empty()) return;
    reportProgress(work.options.hooks, "models", fitted, limit);
    tbb::parallel_for(std::size_t{0}, next.size(), [&](std::size_t k) { fitModel(work, *next[k]); });
    fitted += next.size();
  }
}

}  // namespace

CompetingModel fittedModelOf(const DiagnosisWork& work, const std::vector<deflection::Effect>& effects) {
  std::vector<int> causes;
  for (int index = 0; index < static_cast<int>(work.causes.causes.size()); ++index) {
    const auto& own = work.cause(index).effects;
    if (own.size() == 1 &&
        std::ranges::any_of(effects, [&](const auto& effect) { return areOne(effect, own.front()); }))
      causes.push_back(index);
  }
  if (causes.size() != effects.size()) return {};
  const auto terms = bestTerms(work, causes), full = fullTerms(work, terms);
  CompetingModel best;
  best.log_evidence = -std::numeric_limits<double>::infinity();
  const auto attempt = [&](const std::vector<ModelTerm>& as, const VectorXd& from) {
    CompetingModel model = weigh(work, as, logShareOf(work, as));
    if (from.size() > 0) model.sizes = from;
    fitModel(work, model);
    if (model.logWeight() > best.logWeight()) best = std::move(model);
  };
  attempt(terms, {});
  if (full != terms) attempt(full, {});
  if (const VectorXd from = sizesIn(work, full, effects); from.size() > 0) attempt(full, from);
  return best;
}

double leaderWindow(double best, double nothing) { return std::max(kLeaderWindow, kLeaderShare * (best - nothing)); }

void fitLeaders(DiagnosisWork& work) {
  fitNearest(work);
  if (work.noise.size() > 1) return;
  const double more = errorBeyondBest(work);
  if (!(more > 0) || !doubtNoise(work, more)) return;
  compareModels(work);
  fitNearest(work);
}

}  // namespace tubeplan::calibration
