#include "calibration/diagnosis/model_selection/model_evidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "calibration/diagnosis/model_selection/model_terms.hpp"
#include "deflection/resized.hpp"

namespace tubeplan::calibration {

namespace {

// Prior of an effect's size, as a mixture of normal distributions. Each pair is a standard deviation, in units of the
// largest usual size, and its weight. The mixture covers all orders of magnitude up to the sizes found on real
// machines; larger sizes have little weight.
constexpr std::array<std::array<double, 2>, 5> kSizes{{{0.5, 0.3}, {0.15, 0.25}, {0.05, 0.2}, {0.012, 0.15}, {4, 0.1}}};

double logPriorOf(const DiagnosisWork& work, const std::vector<ModelTerm>& terms) {
  double log = logPriorOfCount(terms.size());
  for (std::size_t k = 0; k < terms.size(); ++k)
    log += std::log(std::max(1e-300, work.cause(terms[k].cause).prior)) + std::log(static_cast<double>(k + 1));
  return log;
}

/// Adds to a model its evidence for another noise assumption or another prior scale of its effects.
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
    deflection::takeSized(model.sizes, evidence.sizes);
    deflection::takeSized(model.sigma, evidence.sigma);
  }
  model.log_evidence = after;
}

}  // namespace

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

double estimateLogWeight(const DiagnosisWork& work, const std::vector<ModelTerm>& terms, double log_share,
                         const CompetingModel& like) {
  const NoiseHypothesis& noise = work.noise[likelyNoise(work, like)];
  double log = -std::numeric_limits<double>::infinity();
  for (const auto& [scale, share] : kSizes)
    log = logSum(log, noise.evidence->of(sizesOf(work, terms, scale), like.level).log + std::log(share));
  return log + noise.log_prior + logPriorOf(work, terms) + log_share;
}

}  // namespace tubeplan::calibration
