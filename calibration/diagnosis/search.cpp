#include "calibration/diagnosis/search.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

namespace tubeplan::calibration {

namespace {

constexpr double kTwinFall = 20;     // criterion beyond the best to which candidates are fitted too
constexpr double kTwinShare = 0.15;  // the same as a share of what the best leaves
constexpr int kMostLeaders = 14;
constexpr int kPairsFitted = 10;
constexpr int kPairFirsts = 40;  // candidates, best first, that pairs are made of

std::vector<Explanation> fitAll(const DiagnosisWork& work, const std::vector<Scored>& some, std::string_view stage) {
  std::vector<Explanation> fits;
  std::size_t done = 0;
  for (const Scored& scored : some) {
    tell(work.options.hooks, stage, done++, some.size());
    Explanation fit = fitExplanation(work.basis, work.catalogue, work.space, scored.variants);
    if (std::isfinite(fit.chi2)) fits.push_back(std::move(fit));
  }
  std::stable_sort(fits.begin(), fits.end(),
                   [](const Explanation& a, const Explanation& b) { return a.criterion < b.criterion; });
  return fits;
}

/// The leaders, and all others that come near them.
std::vector<Scored> leadersOf(const DiagnosisWork& work, const std::vector<Scored>& singles) {
  std::vector<Scored> some;
  if (singles.empty()) return some;
  const double left = work.basis.residual.r.squaredNorm() + singles.front().criterion;
  const double near = singles.front().criterion + std::max(kTwinFall, kTwinShare * left);
  for (const Scored& scored : singles) {
    const bool is_near = scored.criterion < near;
    const auto most = static_cast<std::size_t>(is_near ? kMostLeaders : work.options.leaders);
    if (some.size() < most && scored.criterion < 0) some.push_back(scored);
  }
  return some;
}

/// Two errors of one joint's reading together follow about any function of it: they would name what is not known.
bool followOneJoint(const Catalogue& catalogue, int a, int b) {
  const auto& first = catalogue.candidates[static_cast<std::size_t>(a)].neutral;
  const auto& second = catalogue.candidates[static_cast<std::size_t>(b)].neutral;
  const auto stage = [](const deflection::Effect& effect) {
    return deflection::effectKinds()[static_cast<std::size_t>(effect.kind)].stage;
  };
  return stage(first) == deflection::EffectStage::kReading && stage(second) == deflection::EffectStage::kReading &&
         first.place.row == second.place.row;
}

std::vector<Scored> bestPairs(const DiagnosisWork& work, const std::vector<Scored>& singles) {
  const auto& variants = work.space.variants();
  std::map<int, std::vector<int>> of_candidate;
  for (int v = 0; v < static_cast<int>(variants.size()); ++v)
    of_candidate[variants[static_cast<std::size_t>(v)].candidate].push_back(v);
  std::vector<Scored> pairs;
  const std::size_t firsts = std::min<std::size_t>(singles.size(), kPairFirsts);
  for (std::size_t i = 0; i < firsts; ++i) {
    goOn(work.options.hooks.stop);
    const int a = singles[i].variants.front();
    for (const auto& [candidate, some] : of_candidate) {
      if (candidate == variants[static_cast<std::size_t>(a)].candidate) continue;
      if (followOneJoint(work.catalogue, variants[static_cast<std::size_t>(a)].candidate, candidate)) continue;
      Scored best{{}, 0, 1e300};
      for (const int b : some) {
        const Score score = work.space.score({a, b});
        if (!score.is_physical) continue;
        const int numbers =
            variants[static_cast<std::size_t>(a)].numbers + variants[static_cast<std::size_t>(b)].numbers;
        if (numbers * work.log_n - score.fall < best.criterion)
          best = {{a, b}, score.fall, numbers * work.log_n - score.fall};
      }
      if (!best.variants.empty()) pairs.push_back(best);
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Scored& a, const Scored& b) { return a.criterion < b.criterion; });
  std::set<std::set<int>> seen;
  std::vector<Scored> distinct;
  for (const Scored& pair : pairs) {
    const std::set<int> both{variants[static_cast<std::size_t>(pair.variants[0])].candidate,
                             variants[static_cast<std::size_t>(pair.variants[1])].candidate};
    if (!seen.insert(both).second) continue;
    distinct.push_back(pair);
    if (distinct.size() == kPairsFitted) break;
  }
  return distinct;
}

/// Sizes that no machine has are no explanation.
bool isPlausible(const Explanation& explanation) {
  for (const auto& effect : explanation.effects) {
    const auto& kind = deflection::effectKinds()[static_cast<std::size_t>(effect.fitted.kind)];
    for (std::size_t v = 0; v < effect.numbers.size(); ++v) {
      const auto& number = effect.numbers[v];
      if (kind.parameters[v].is_shape || std::isnan(number.sigma)) continue;
      if (std::abs(number.value - kind.parameters[v].neutral) > kind.parameters[v].plausible + 2 * number.sigma)
        return false;
    }
  }
  return true;
}

bool isEnough(const Explanation& fit, double lack_of_fit) {
  return fit.p_value >= lack_of_fit && fit.smooth_p_value >= lack_of_fit;
}

std::vector<Explanation> withinGap(const std::vector<Explanation>& fits, double gap, double lack_of_fit) {
  std::vector<Explanation> some;
  for (const auto& fit : fits)
    if (fit.criterion <= fits.front().criterion + gap && isEnough(fit, lack_of_fit)) some.push_back(fit);
  return some;
}

}  // namespace

std::vector<Scored> bestVariants(const DiagnosisWork& work) {
  std::map<int, Scored> best;
  const auto& variants = work.space.variants();
  for (int v = 0; v < static_cast<int>(variants.size()); ++v) {
    const Score score = work.space.score({v});
    if (!score.is_physical) continue;
    const Scored scored{{v}, score.fall, variants[static_cast<std::size_t>(v)].numbers * work.log_n - score.fall};
    const auto [at, is_new] = best.emplace(variants[static_cast<std::size_t>(v)].candidate, scored);
    if (!is_new && scored.criterion < at->second.criterion) at->second = scored;
  }
  std::vector<Scored> list;
  for (const auto& [candidate, scored] : best) list.push_back(scored);
  std::stable_sort(list.begin(), list.end(),
                   [](const Scored& a, const Scored& b) { return a.criterion < b.criterion; });
  return list;
}

std::vector<Explanation> plausibleSingles(const DiagnosisWork& work, const std::vector<Scored>& singles) {
  std::vector<Explanation> fits = fitAll(work, leadersOf(work, singles), "effects");
  std::erase_if(fits, [](const Explanation& fit) { return !isPlausible(fit); });
  return fits;
}

Finding findExplanations(const DiagnosisWork& work, const std::vector<Scored>& singles) {
  Finding finding;
  const auto& options = work.options;
  finding.fits = plausibleSingles(work, singles);
  if (!finding.fits.empty()) finding.good = withinGap(finding.fits, options.gap, options.lack_of_fit);
  if (options.most_effects < 2) return finding;
  const double single = finding.fits.empty() ? 1e300 : finding.fits.front().criterion;
  std::vector<Explanation> pairs;
  for (auto& fit : fitAll(work, bestPairs(work, singles), "pairs of effects"))
    if (isPlausible(fit) && fit.criterion < single - options.gap) pairs.push_back(std::move(fit));
  if (pairs.empty()) return finding;
  const auto good = withinGap(pairs, options.gap, options.lack_of_fit);
  if (!good.empty()) finding.good = good;
  finding.fits.insert(finding.fits.end(), pairs.begin(), pairs.end());
  std::stable_sort(finding.fits.begin(), finding.fits.end(),
                   [](const Explanation& a, const Explanation& b) { return a.criterion < b.criterion; });
  return finding;
}

}  // namespace tubeplan::calibration
