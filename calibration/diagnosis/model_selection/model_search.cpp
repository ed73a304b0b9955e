#include "calibration/diagnosis/model_selection/model_search.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "calibration/diagnosis/model_selection/model_evidence.hpp"
#include "calibration/diagnosis/model_selection/model_terms.hpp"

namespace tubeplan::calibration {

namespace {

// The search ends if the best model with one cause has a log weight lower by more than this than the model without
// causes.
constexpr double kHopeless = 5;
// Maximum number of models that another cause is added to, counted separately for single and for collective causes.
constexpr std::size_t kMostSeeds = 20;
// Maximum number of extended models that are kept after the quick estimate, counted in the same way.
constexpr std::size_t kMostExtendedModels = 40;

/// Returns quick estimates of each seed extended by the best term of every cause: grouped by seed, one estimate per
/// cause.
std::vector<CandidateModel> estimateExtensions(const DiagnosisWork& work, const std::vector<CompetingModel>& seeds) {
  const std::size_t causes = work.causes.causes.size();
  std::vector<CandidateModel> candidates(seeds.size() * causes);
  std::atomic<bool> is_stopped = false;
  tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t at) {
    const CompetingModel& seed = seeds[at / causes];
    const int cause = static_cast<int>(at % causes);
    if (is_stopped || !isVisible(work, cause) || !areCombinable(work, seed.terms, cause)) return;
    if (shouldStop(work.basis.stop)) {
      is_stopped = true;
      return;
    }
    candidates[at] = bestExtension(work, seed, cause, seed.terms.empty());
  });
  throwIfStopped(work.basis.stop);
  return candidates;
}

/// Returns indices of the most probable estimates, in descending order, without repeated sets of causes. At most `most`
/// estimates with only single causes are kept, and at most `most` with collective causes (representsSeveralCauses()),
/// so that neither kind excludes the other.
std::vector<std::size_t> mostProbable(const DiagnosisWork& work, const std::vector<CandidateModel>& candidates,
                                      std::size_t most) {
  std::vector<std::size_t> order(candidates.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(
      order, [&](std::size_t a, std::size_t b) { return candidates[a].log_weight > candidates[b].log_weight; });
  std::set<std::vector<int>> seen;
  std::vector<std::size_t> chosen;
  std::array<std::size_t, 2> count{};
  for (const std::size_t k : order) {
    if (!std::isfinite(candidates[k].log_weight) || !seen.insert(causesOf(candidates[k].terms)).second) continue;
    if (count[representsSeveralCauses(work, candidates[k].terms)]++ < most) chosen.push_back(k);
  }
  return chosen;
}

/// Returns the models extended by one cause, most probable first: the best term of every cause added to each seed.
std::vector<CompetingModel> extended(const DiagnosisWork& work, const std::vector<CompetingModel>& seeds) {
  const std::size_t causes = work.causes.causes.size();
  auto candidates = estimateExtensions(work, seeds);
  const auto chosen =
      mostProbable(work, candidates, seeds.front().terms.empty() ? candidates.size() : kMostExtendedModels);
  std::vector<CompetingModel> found(chosen.size());
  tbb::parallel_for(std::size_t{0}, chosen.size(), [&](std::size_t k) {
    if (shouldStop(work.basis.stop)) return;
    CandidateModel& candidate = candidates[chosen[k]];
    const CompetingModel& seed = seeds[chosen[k] / causes];
    const int cause = static_cast<int>(chosen[k] % causes);
    if (!seed.terms.empty() && termsOf(work, cause).size() >= kManyTerms)
      candidate = bestExtension(work, seed, cause, true);
    found[k] = weigh(work, candidate.terms, candidate.log_share);
  });
  throwIfStopped(work.basis.stop);
  sortByWeight(found);
  return found;
}

/// Returns the models to extend. A cause that is improbable on its own may belong to the best set of several causes. A
/// collective cause gains more than each of the single causes that it contains. Models with collective causes are
/// therefore compared only with one another.
std::vector<CompetingModel> leadersOf(const DiagnosisWork& work, const std::vector<CompetingModel>& models,
                                      std::size_t most) {
  std::vector<CompetingModel> leaders;
  for (const bool of_many : {false, true}) {
    std::size_t count = 0;
    for (const CompetingModel& model : models)
      if (representsSeveralCauses(work, model.terms) == of_many && count++ < most) leaders.push_back(model);
  }
  sortByWeight(leaders);
  return leaders;
}

}  // namespace

CandidateModel bestExtension(const DiagnosisWork& work, const CompetingModel& seed, int cause, bool of_all) {
  CandidateModel best;
  for (const WeighedTerm& more : of_all ? termsOf(work, cause) : someTermsOf(work, cause)) {
    auto terms = seed.terms;
    terms.push_back(more.term);
    const double log_share = seed.log_share + more.log_share;
    const double log_weight = estimateLogWeight(work, terms, log_share, seed);
    if (log_weight > best.log_weight) best = {std::move(terms), log_share, log_weight};
  }
  return best;
}

void compareModels(DiagnosisWork& work) {
  const CompetingModel nothing = weigh(work, {}, 0);
  work.models = {nothing};
  std::vector<CompetingModel> level{nothing};
  // Best log weights without and with collective causes. The search ends only when neither improves: a further cause
  // adds little to a collective cause, but several single causes may still become better.
  std::array<double, 2> best{nothing.logWeight(), nothing.logWeight()};
  for (int depth = 1; depth <= work.options.most_causes; ++depth) {
    reportProgress(work.options.hooks, "causes", static_cast<std::size_t>(depth),
                   static_cast<std::size_t>(work.options.most_causes));
    level = extended(work, leadersOf(work, level, kMostSeeds));
    if (level.empty()) break;
    work.models.insert(work.models.end(), level.begin(), level.end());
    bool gains = false;
    for (const bool of_many : {false, true}) {
      const auto first = std::ranges::find_if(
          level, [&](const CompetingModel& model) { return representsSeveralCauses(work, model.terms) == of_many; });
      if (first == level.end()) continue;
      const double before = std::exchange(best[of_many], std::max(best[of_many], first->logWeight()));
      gains |= first->logWeight() >= before - (depth == 1 ? kHopeless : 0);
    }
    if (!gains) break;
  }
  sortByWeight(work.models);
}

}  // namespace tubeplan::calibration
