#include "calibration/diagnosis/competing_models.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "calibration/diagnosis/model_fit.hpp"
#include "calibration/diagnosis/noise_hypotheses.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

// Probability beforehand of so many causes.
constexpr std::array<double, 5> kCount{0.5, 0.35, 0.11, 0.03, 0.01};
// A size is of any order up to what real machines have, or now and then far beyond.
constexpr std::array<std::array<double, 2>, 5> kSizes{
    {{0.5, 0.3}, {0.15, 0.25}, {0.05, 0.2}, {0.012, 0.15}, {4, 0.1}}};  // sigma over the largest usual, share
constexpr double kHopeless = 5;          // of log weight below nothing missing: from no such cause pairs are made
constexpr std::size_t kMostSeeds = 20;   // models that are extended by another cause
constexpr std::size_t kMostLooked = 40;  // extensions that a quick look leaves
constexpr std::size_t kManyTerms = 60;   // ways to say a cause, from which only some are looked at
constexpr std::size_t kFitsAtOnce = 6;   // side by side
constexpr int kManyRows = 20000;         // from which fewer leaders are fitted
constexpr double kLeastVisible = 1;      // noise sigmas that a cause of the largest usual size must show
constexpr double kLeaderWindow = 8;      // of log weight behind the best: models that are fitted ...
constexpr double kLeaderShare = 0.075;   // ... or a share of what the best gains, since linear evidence errs with it
constexpr int kMostNumbers = 8;          // of a cause of which choices of some are tried

/// The choices of a cause's numbers that are tried: all that there are of a few, else each alone and all.
std::vector<std::vector<int>> choicesOf(const Cause& cause, int numbers) {
  std::vector<int> all(static_cast<std::size_t>(numbers));
  for (int k = 0; k < numbers; ++k) all[static_cast<std::size_t>(k)] = k;
  if (cause.effects.size() > 1 || numbers > kMostNumbers) return {all};
  std::vector<std::vector<int>> choices;
  for (unsigned mask = 1; mask < (1U << numbers); ++mask) {
    std::vector<int> choice;
    for (const int k : all)
      if (mask & (1U << k)) choice.push_back(k);
    if (numbers <= 4 || choice.size() == 1 || static_cast<int>(choice.size()) == numbers) choices.push_back(choice);
  }
  return choices;
}

/// Every way to say a cause, with its share of the cause's probability.
struct WeighedTerm {
  ModelTerm term;
  double log_share = 0;
};

double logShare(const Cause& cause, std::size_t choices) {
  return -std::log(static_cast<double>(cause.levels.size() * choices));
}

int countNumbers(const DiagnosisWork& work, int cause, int level) {
  return static_cast<int>(work.signatures->columnsOf(cause, level).size());
}

std::vector<WeighedTerm> termsOf(const DiagnosisWork& work, int index) {
  const Cause& cause = work.cause(index);
  std::vector<WeighedTerm> terms;
  for (int level = 0; level < static_cast<int>(cause.levels.size()); ++level) {
    const auto choices = choicesOf(cause, countNumbers(work, index, level));
    for (const auto& choice : choices) terms.push_back({{index, level, choice}, logShare(cause, choices.size())});
  }
  return terms;
}

double logShareOf(const DiagnosisWork& work, const ModelTerm& term) {
  const Cause& cause = work.cause(term.cause);
  return logShare(cause, choicesOf(cause, countNumbers(work, term.cause, term.level)).size());
}

/// Of very many ways to say a cause those at every fourth level, with one number or all.
std::vector<WeighedTerm> someTermsOf(const DiagnosisWork& work, int index) {
  auto terms = termsOf(work, index);
  if (terms.size() < kManyTerms) return terms;
  std::size_t most = 0;
  for (const WeighedTerm& t : terms) most = std::max(most, t.term.numbers.size());
  std::erase_if(terms, [&](const WeighedTerm& t) {
    return t.term.level % 4 != 0 || (t.term.numbers.size() != 1 && t.term.numbers.size() != most);
  });
  return terms;
}

int signOf(const SignatureColumn& column) { return column.lower == 0 ? 1 : column.upper == 0 ? -1 : 0; }

std::vector<PriorSize> sizesOf(const DiagnosisWork& work, const std::vector<ModelTerm>& terms, double scale) {
  std::vector<PriorSize> sizes;
  for (const ModelTerm& term : terms) {
    const auto& columns = work.signatures->columnsOf(term.cause, term.level);
    for (const int number : term.numbers) {
      const int c = columns[static_cast<std::size_t>(number)];
      const SignatureColumn& column = work.signatures->columns()[static_cast<std::size_t>(c)];
      sizes.push_back({c, column.prior_sigma * (column.is_of_effect ? scale : 1), signOf(column)});
    }
  }
  return sizes;
}

bool hasEffects(const DiagnosisWork& work, const std::vector<ModelTerm>& terms) {
  return std::any_of(terms.begin(), terms.end(), [&](const ModelTerm& t) { return work.cause(t.cause).frees.empty(); });
}

/// Whether a cause at the largest usual size would show at all beyond what the fitted numbers absorb.
bool isVisible(const DiagnosisWork& work, int cause) {
  const auto shows = [&](int column) {
    const double usual = work.signatures->columns()[static_cast<std::size_t>(column)].prior_sigma;
    return work.noise.back().evidence->visibility(column) * usual > kLeastVisible;
  };
  for (int level = 0; level < static_cast<int>(work.cause(cause).levels.size()); ++level) {
    const auto& columns = work.signatures->columnsOf(cause, level);
    if (std::any_of(columns.begin(), columns.end(), shows)) return true;
  }
  return false;
}

bool mayStandTogether(const DiagnosisWork& work, const std::vector<ModelTerm>& terms, int cause) {
  return std::none_of(terms.begin(), terms.end(), [&](const ModelTerm& term) {
    return term.cause == cause || overlap(work.cause(term.cause), work.cause(cause));
  });
}

double logPriorOf(const DiagnosisWork& work, const std::vector<ModelTerm>& terms) {
  double log = logPriorOfCount(terms.size());
  for (std::size_t k = 0; k < terms.size(); ++k)
    log += std::log(std::max(1e-300, work.cause(terms[k].cause).prior)) + std::log(static_cast<double>(k + 1));
  return log;
}

/// Takes one more view of noise or sizes into a model's evidence.
void blend(CompetingModel& model, const WeighedDiscrepancy& evidence, double log_share, const NoiseHypothesis& noise) {
  const double log = evidence.log + log_share + noise.log_prior;
  const double after = logSum(model.log_evidence, log);
  if (!std::isfinite(after)) return;
  const double share = std::exp(log - after);
  model.discrepancy_probability =
      (1 - share) * model.discrepancy_probability + share * evidence.discrepancy_probability;
  const double more_noise = noise.model_error > 0 ? 1 : 0;
  model.more_noise_probability = (1 - share) * model.more_noise_probability + share * more_noise;
  model.scatter_probability =
      (1 - share) * model.scatter_probability + share * more_noise * (1 - evidence.discrepancy_probability);
  if (share > 0.5) {
    model.discrepancy = evidence.discrepancy;
    model.level = evidence.level;
    model.source = evidence.source;
    model.model_error = noise.model_error > 0 ? noise.model_error * evidence.noise_scale : 0;
    model.sizes = evidence.sizes;
    model.sigma = evidence.sigma;
  }
  model.log_evidence = after;
}

/// The evidence of some terms about the baseline, over noise and sizes.
CompetingModel weigh(const DiagnosisWork& work, std::vector<ModelTerm> terms, double log_share) {
  CompetingModel model;
  model.log_share = log_share;
  model.log_prior = logPriorOf(work, terms) + log_share;
  model.terms = std::move(terms);
  blendEvidence(
      work, hasEffects(work, model.terms),
      [&](const NoiseHypothesis& noise, std::size_t, double scale) {
        return WeighedDiscrepancy{noise.evidence->of(sizesOf(work, model.terms, scale)), {}};
      },
      model);
  return model;
}

void sortByWeight(std::vector<CompetingModel>& models) {
  std::stable_sort(models.begin(), models.end(),
                   [](const CompetingModel& a, const CompetingModel& b) { return a.logWeight() > b.logWeight(); });
}

/// A quick look at some terms: by the noise and the discrepancy that suited `like` best.
double lookAt(const DiagnosisWork& work, const std::vector<ModelTerm>& terms, double log_share,
              const CompetingModel& like) {
  const NoiseHypothesis& noise = like.more_noise_probability > 0.5 ? work.noise.back() : work.noise.front();
  double log = -std::numeric_limits<double>::infinity();
  for (const auto& [scale, share] : kSizes)
    log = logSum(log, noise.evidence->of(sizesOf(work, terms, scale), like.level).log + std::log(share));
  return log + noise.log_prior + logPriorOf(work, terms) + log_share;
}

/// One model more, as a quick look saw it.
struct Looked {
  std::vector<ModelTerm> terms;
  double log_share = 0, log_weight = -std::numeric_limits<double>::infinity();
};

/// Of a cause its best term beside what the seed has, of all or only some of its terms.
Looked bestBeside(const DiagnosisWork& work, const CompetingModel& seed, int cause, bool of_all) {
  Looked best;
  for (const WeighedTerm& more : of_all ? termsOf(work, cause) : someTermsOf(work, cause)) {
    auto terms = seed.terms;
    terms.push_back(more.term);
    const double log_share = seed.log_share + more.log_share;
    const double log_weight = lookAt(work, terms, log_share, seed);
    if (log_weight > best.log_weight) best = {std::move(terms), log_share, log_weight};
  }
  return best;
}

/// Says several single causes at once: one at all joints alike, or all of the geometry.
bool saysManyAtOnce(const DiagnosisWork& work, const std::vector<ModelTerm>& terms) {
  return std::any_of(terms.begin(), terms.end(), [&](const ModelTerm& term) {
    const Cause& cause = work.cause(term.cause);
    return cause.effects.size() > 1 || cause.frees.size() > 1;
  });
}

/// The models with one cause more, most probable first: of every cause its best term beside what each of the seeds has.
std::vector<CompetingModel> extended(const DiagnosisWork& work, const std::vector<CompetingModel>& seeds) {
  const std::size_t causes = work.causes.causes.size();
  std::vector<Looked> looked(seeds.size() * causes);
  std::atomic<bool> is_stopped = false;
  tbb::parallel_for(std::size_t{0}, looked.size(), [&](std::size_t at) {
    const CompetingModel& seed = seeds[at / causes];
    const int cause = static_cast<int>(at % causes);
    if (is_stopped || !isVisible(work, cause) || !mayStandTogether(work, seed.terms, cause)) return;
    if (shouldStop(work.basis.stop)) {
      is_stopped = true;
      return;
    }
    looked[at] = bestBeside(work, seed, cause, seed.terms.empty());
  });
  goOn(work.basis.stop);
  std::vector<std::size_t> order(looked.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return looked[a].log_weight > looked[b].log_weight; });
  std::set<std::vector<int>> seen;
  std::vector<std::size_t> chosen;
  const std::size_t most = seeds.front().terms.empty() ? looked.size() : kMostLooked;
  std::array<std::size_t, 2> count{};  // of single ones, and of those that say many at once: neither crowds out others
  for (const std::size_t k : order) {
    if (!std::isfinite(looked[k].log_weight) || !seen.insert(causesOf(looked[k].terms)).second) continue;
    if (count[saysManyAtOnce(work, looked[k].terms)]++ < most) chosen.push_back(k);
  }
  std::vector<CompetingModel> found(chosen.size());
  tbb::parallel_for(std::size_t{0}, chosen.size(), [&](std::size_t k) {
    if (shouldStop(work.basis.stop)) return;
    Looked& look = looked[chosen[k]];
    const CompetingModel& seed = seeds[chosen[k] / causes];
    const int cause = static_cast<int>(chosen[k] % causes);
    if (!seed.terms.empty() && termsOf(work, cause).size() >= kManyTerms) look = bestBeside(work, seed, cause, true);
    found[k] = weigh(work, look.terms, look.log_share);
  });
  goOn(work.basis.stop);
  sortByWeight(found);
  return found;
}

/// Those that are gone on from: however far behind the best a cause is alone, it may be one of the best few together.
/// One that says many causes at once gains what a few of them together would, and none of them alone: single ones are
/// held against single ones.
std::vector<CompetingModel> leadersOf(const DiagnosisWork& work, const std::vector<CompetingModel>& models,
                                      std::size_t most) {
  std::vector<CompetingModel> leaders;
  for (const bool of_many : {false, true}) {
    std::size_t count = 0;
    for (const CompetingModel& model : models)
      if (saysManyAtOnce(work, model.terms) == of_many && count++ < most) leaders.push_back(model);
  }
  sortByWeight(leaders);
  return leaders;
}

bool saysNothing(const CompetingModel& model) { return model.terms.empty(); }

/// The terms that a fit found a size of.
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

/// The same causes with all their numbers.
std::vector<ModelTerm> fullTerms(const DiagnosisWork& work, std::vector<ModelTerm> terms) {
  for (ModelTerm& term : terms) {
    term.numbers.resize(static_cast<std::size_t>(countNumbers(work, term.cause, term.level)));
    std::iota(term.numbers.begin(), term.numbers.end(), 0);
  }
  return terms;
}

double logShareOf(const DiagnosisWork& work, const std::vector<ModelTerm>& terms) {
  double log_share = 0;
  for (const ModelTerm& term : terms) log_share += logShareOf(work, term);
  return log_share;
}

/// Of each of these causes the term that is best beside the others'.
std::vector<ModelTerm> bestTerms(const DiagnosisWork& work, const std::vector<int>& causes) {
  CompetingModel seed = work.models.front();
  std::vector<ModelTerm> terms;
  for (int pass = 0; pass < 2; ++pass)
    for (const int cause : causes) {
      seed.terms = terms;
      std::erase_if(seed.terms, [&](const ModelTerm& term) { return term.cause == cause; });
      seed.log_share = logShareOf(work, seed.terms);
      terms = bestBeside(work, seed, cause, true).terms;
    }
  return terms;
}

/// Sizes of the terms' numbers in these effects, in units; none where all of them are neutral.
VectorXd sizesIn(const DiagnosisWork& work, const std::vector<ModelTerm>& terms,
                 const std::vector<deflection::Effect>& effects) {
  std::vector<double> sizes;
  for (const ModelTerm& term : terms) {
    const Cause& cause = work.cause(term.cause);
    const auto same = std::find_if(effects.begin(), effects.end(), [&](const deflection::Effect& effect) {
      return effect.kind == cause.effects.front().kind && effect.place == cause.effects.front().place;
    });
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

/// A model that says the best fitted one otherwise and is not fitted yet. Linear evidence asks for a further cause
/// where only another's time or shape was coarse: without the causes that the fit found no size of. And it leaves out a
/// number that a strong error elsewhere hid: with all numbers of the causes.
CompetingModel* unfittedVariant(DiagnosisWork& work) {
  const CompetingModel& best = work.models.front();
  if (!best.is_fitted || best.terms.empty() || !std::isfinite(best.log_evidence)) return nullptr;
  for (const auto& terms : {significantTerms(best), fullTerms(work, best.terms)}) {
    if (terms.empty() || terms == best.terms) continue;
    const auto same = std::find_if(work.models.begin(), work.models.end(),
                                   [&](const CompetingModel& model) { return model.terms == terms; });
    if (same != work.models.end() && same->is_fitted) continue;
    if (same != work.models.end()) return &*same;
    work.models.push_back(weigh(work, terms, logShareOf(work, terms)));
    return &work.models.back();
  }
  return nullptr;
}

/// That of nothing missing, and leaders until no other comes near the best of them.
void fitNearest(DiagnosisWork& work) {
  auto& models = work.models;
  CompetingModel& of_nothing = *std::find_if(models.begin(), models.end(), saysNothing);
  const double nothing = of_nothing.logWeight();
  fitModel(work, of_nothing);
  // So many readings part the models by far more than linear evidence errs, and each fit takes seconds.
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
    tell(work.options.hooks, "models", fitted, limit);
    tbb::parallel_for(std::size_t{0}, next.size(), [&](std::size_t k) { fitModel(work, *next[k]); });
    fitted += next.size();
  }
}

}  // namespace

double logPriorOfCount(std::size_t causes) { return std::log(kCount[std::min(causes, kCount.size() - 1)]); }

std::vector<int> causesOf(const std::vector<ModelTerm>& terms) {
  std::vector<int> causes;
  for (const ModelTerm& term : terms) causes.push_back(term.cause);
  std::sort(causes.begin(), causes.end());
  return causes;
}

void blendEvidence(const DiagnosisWork& work, bool has_effects, const EvidenceOf& of, CompetingModel& model) {
  model.log_evidence = -std::numeric_limits<double>::infinity();
  model.discrepancy_probability = model.more_noise_probability = model.scatter_probability = 0;
  for (std::size_t n = 0; n < work.noise.size(); ++n) {
    const NoiseHypothesis& noise = work.noise[n];
    if (!has_effects) {
      blend(model, of(noise, n, 1), 0, noise);
      continue;
    }
    for (const auto& [scale, share] : kSizes) blend(model, of(noise, n, scale), std::log(share), noise);
  }
}

WeighedDiscrepancy withSources(const Evidence& evidence, const SourceEvidence& single, const EvidenceOptions& options) {
  WeighedDiscrepancy weighed{evidence, {}};
  const double none = 1 - options.discrepancy_prior - options.source_prior;
  const double log_single = evidence.log_none + std::log(options.source_prior / none) + single.log_factor;
  if (!std::isfinite(log_single)) return weighed;
  weighed.log = logSum(evidence.log, log_single);
  const double log_all_terms = std::log(std::max(1e-300, evidence.discrepancy_probability)) + evidence.log;
  weighed.discrepancy_probability = -std::expm1(evidence.log_none - weighed.log);
  if (log_single < std::max(log_all_terms, evidence.log_none)) return weighed;
  weighed.source = single;
  weighed.discrepancy = single.size;
  return weighed;
}

const CompetingModel& modelOfNothing(const DiagnosisWork& work) {
  return *std::find_if(work.models.begin(), work.models.end(), saysNothing);
}

CompetingModel fittedModelOf(const DiagnosisWork& work, const std::vector<deflection::Effect>& effects) {
  std::vector<int> causes;
  for (int index = 0; index < static_cast<int>(work.causes.causes.size()); ++index) {
    const auto& own = work.cause(index).effects;
    if (own.size() == 1 && std::any_of(effects.begin(), effects.end(), [&](const deflection::Effect& effect) {
          return effect.kind == own.front().kind && effect.place == own.front().place;
        }))
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

void compareModels(DiagnosisWork& work) {
  const CompetingModel nothing = weigh(work, {}, 0);
  work.models = {nothing};
  std::vector<CompetingModel> level{nothing};
  // One that says many causes at once leaves little to gain beside it; a few single ones may still say it better.
  std::array<double, 2> best{nothing.logWeight(), nothing.logWeight()};
  for (int depth = 1; depth <= work.options.most_causes; ++depth) {
    tell(work.options.hooks, "causes", static_cast<std::size_t>(depth),
         static_cast<std::size_t>(work.options.most_causes));
    level = extended(work, leadersOf(work, level, kMostSeeds));
    if (level.empty()) break;
    work.models.insert(work.models.end(), level.begin(), level.end());
    bool gains = false;
    for (const bool of_many : {false, true}) {
      const auto first = std::find_if(level.begin(), level.end(), [&](const CompetingModel& model) {
        return saysManyAtOnce(work, model.terms) == of_many;
      });
      if (first == level.end()) continue;
      const double before = std::exchange(best[of_many], std::max(best[of_many], first->logWeight()));
      gains |= first->logWeight() >= before - (depth == 1 ? kHopeless : 0);
    }
    if (!gains) break;
  }
  sortByWeight(work.models);
}

void fitLeaders(DiagnosisWork& work) {
  fitNearest(work);
  if (work.noise.size() > 1) return;
  const double more = errorBeyondBest(work);
  if (!(more > 0) || !doubtNoise(work, more)) return;
  compareModels(work);
  fitNearest(work);
}

}  // namespace tubeplan::calibration
