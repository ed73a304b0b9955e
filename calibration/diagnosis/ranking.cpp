#include "calibration/diagnosis/ranking.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace tubeplan::calibration {

using Eigen::Index;

namespace {

constexpr double kUnknownOdds = 0.02;  // of something unknown to a model whose misfit says nothing against it

FoundNumber mainSize(const DiagnosisWork& work, const Scored& scored) {
  const Variant& variant = work.space.variants()[static_cast<std::size_t>(scored.variants.front())];
  const Candidate& candidate = work.catalogue.candidates[static_cast<std::size_t>(variant.candidate)];
  const Score score = work.space.score(scored.variants);
  Index most = 0;
  score.sizes.cwiseAbs().maxCoeff(&most);
  const int value = candidate.sizes[static_cast<std::size_t>(variant.sizes[static_cast<std::size_t>(most)])];
  const double unit = candidate.unit[static_cast<std::size_t>(value)];
  const auto& kind = deflection::effectKinds()[static_cast<std::size_t>(candidate.neutral.kind)];
  return {kind.parameters[static_cast<std::size_t>(value)].name,
          deflection::numberOf(work.basis.fitted.arm, candidate.neutral, value).quantity,
          candidate.neutral.values[static_cast<std::size_t>(value)] + score.sizes[most] * unit,
          score.sigma[most] * unit};
}

std::string nameOf(const std::string& effect, const std::string& at) { return effect + "@" + at; }

/// The belief left in a model by the p-value of its misfit: the bound on what speaks against it is -e p ln p (Sellke,
/// Bayarri and Berger 2001).
double beliefOf(double p_value) {
  const double p = std::clamp(p_value, 1e-300, 1.);
  const double against = p < std::exp(-1) ? -std::exp(1) * p * std::log(p) : 1;
  return 1 / (1 + kUnknownOdds / against);
}

/// A model's weight before it is shared out, and the effects that it has.
struct WeighedModel {
  double criterion = 0;  ///< over the baseline's numbers
  double belief = 1;
  std::vector<std::string> effects;
};

std::vector<WeighedModel> weigh(const DiagnosisWork& work, const std::vector<Scored>& singles,
                                const std::vector<Explanation>& fits, const Diagnosis& result) {
  const double base_numbers = static_cast<double>(work.basis.unknowns.size()) * work.log_n;
  std::vector<WeighedModel> models;
  std::set<std::string> fitted;
  for (const auto& fit : fits) {
    WeighedModel model{fit.criterion - base_numbers, beliefOf(std::min(fit.p_value, fit.smooth_p_value)), {}};
    for (const auto& effect : fit.effects) model.effects.push_back(nameOf(effect.effect, effect.at));
    if (fit.effects.size() == 1) fitted.insert(model.effects.front());
    models.push_back(std::move(model));
  }
  for (const Scored& scored : singles) {
    const Variant& variant = work.space.variants()[static_cast<std::size_t>(scored.variants.front())];
    const Candidate& candidate = work.catalogue.candidates[static_cast<std::size_t>(variant.candidate)];
    if (fitted.contains(nameOf(candidate.effect, candidate.at))) continue;
    const double p_value = chiSquareTail(result.chi2 - scored.fall, result.degrees_of_freedom - variant.numbers);
    models.push_back({result.chi2 + scored.criterion, beliefOf(p_value), {nameOf(candidate.effect, candidate.at)}});
  }
  return models;
}

/// An effect's share of the weights, and its probability: what is believed of that.
struct Share {
  double weight = 0, probability = 0;
};

/// Criteria are taken over `noise`, the variance that the best model leaves where none is enough.
std::map<std::string, Share> shareOut(std::vector<WeighedModel> models, double none, double none_prior, double noise) {
  for (auto& model : models) model.criterion /= noise;
  none /= noise;
  double least = none;
  for (const auto& model : models) least = std::min(least, model.criterion);
  double total = none_prior * std::exp(-(none - least) / 2);
  for (const auto& model : models) total += std::exp(-(model.criterion - least) / 2);
  std::map<std::string, Share> shares;
  for (const auto& model : models)
    for (const auto& effect : model.effects) {
      const double weight = std::exp(-(model.criterion - least) / 2) / total;
      shares[effect].weight += weight;
      shares[effect].probability += weight * model.belief;
    }
  return shares;
}

/// The variance that the best model leaves, of a noise of 1 as stated, where even that one is refused.
double noiseLeft(const std::vector<Explanation>& fits, const Diagnosis& result, double lack_of_fit) {
  double chi2 = result.chi2;
  for (const auto& fit : fits) chi2 = std::min(chi2, fit.chi2);
  if (chiSquareTail(chi2, result.degrees_of_freedom) >= lack_of_fit) return 1;
  return std::max(1., chi2 / std::max(1, result.degrees_of_freedom));
}

/// The size that stands farthest from none, as fitted.
void takeFitted(const Explanation& fit, double chi2, RankedEffect& entry) {
  entry.fall = chi2 - fit.chi2;
  double largest = -1;
  for (const auto& number : fit.effects.front().numbers)
    if (std::isfinite(number.sigma) && number.sigma > 0 && std::abs(number.value) / number.sigma > largest) {
      largest = std::abs(number.value) / number.sigma;
      entry.size = number;
    }
}

}  // namespace

void rank(const DiagnosisWork& work, const std::vector<Scored>& singles, const std::vector<Explanation>& fits,
          Diagnosis& result) {
  std::map<std::string, const Explanation*> fitted;
  for (const auto& fit : fits)
    if (fit.effects.size() == 1) fitted.emplace(nameOf(fit.effects.front().effect, fit.effects.front().at), &fit);
  const auto shares = shareOut(weigh(work, singles, fits, result), result.chi2, static_cast<double>(singles.size()),
                               noiseLeft(fits, result, work.options.lack_of_fit));
  for (const Scored& scored : singles) {
    const int first = scored.variants.front();
    const Variant& variant = work.space.variants()[static_cast<std::size_t>(first)];
    const Candidate& candidate = work.catalogue.candidates[static_cast<std::size_t>(variant.candidate)];
    RankedEffect entry;
    entry.effect = candidate.effect;
    entry.at = candidate.at;
    entry.fall = scored.fall;
    entry.size = mainSize(work, scored);
    entry.kept_fraction = work.space.keptFraction(first);
    entry.p_value = std::pow(10., -work.space.evidence(first, work.space.score(scored.variants)));
    entry.correlation = work.space.correlation(first, singles.front().variants.front());
    const std::string name = nameOf(entry.effect, entry.at);
    if (const auto at = fitted.find(name); at != fitted.end()) takeFitted(*at->second, result.chi2, entry);
    if (const auto at = shares.find(name); at != shares.end()) entry.probability = at->second.probability;
    result.ranking.push_back(std::move(entry));
  }
  const auto weightOf = [&](const RankedEffect& entry) {
    const auto at = shares.find(nameOf(entry.effect, entry.at));
    return at == shares.end() ? 0 : at->second.weight;
  };
  std::stable_sort(result.ranking.begin(), result.ranking.end(), [&](const RankedEffect& a, const RankedEffect& b) {
    return weightOf(a) != weightOf(b) ? weightOf(a) > weightOf(b) : a.fall > b.fall;
  });
}

void listDetectable(const DiagnosisWork& work, double threshold, Diagnosis& result) {
  // Power four in five at the catalogue's own threshold: the signature must be that many sigmas long.
  const double sigmas = std::sqrt(2 * std::log(10.) * threshold) + 0.84;
  std::set<int> seen;
  const auto& variants = work.space.variants();
  for (int v = 0; v < static_cast<int>(variants.size()); ++v) {
    const Variant& variant = variants[static_cast<std::size_t>(v)];
    if (variant.sizes.size() != 1 || !seen.insert(variant.candidate).second) continue;
    const Candidate& candidate = work.catalogue.candidates[static_cast<std::size_t>(variant.candidate)];
    const int value = candidate.sizes[static_cast<std::size_t>(variant.sizes.front())];
    const auto& kind = deflection::effectKinds()[static_cast<std::size_t>(candidate.neutral.kind)];
    const double units = sigmas / std::max(1e-300, work.space.visibility(v));
    result.detectable.push_back({candidate.effect, candidate.at, kind.parameters[static_cast<std::size_t>(value)].name,
                                 deflection::numberOf(work.basis.fitted.arm, candidate.neutral, value).quantity,
                                 units * candidate.unit[static_cast<std::size_t>(value)], units > 1});
  }
}

}  // namespace tubeplan::calibration
