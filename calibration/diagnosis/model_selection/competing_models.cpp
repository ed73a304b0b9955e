#include "calibration/diagnosis/model_selection/competing_models.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tubeplan::calibration {

namespace {

// Prior probability of each number of causes, starting at zero.
constexpr std::array<double, 5> kCount{0.5, 0.35, 0.11, 0.03, 0.01};

}  // namespace

double logPriorOfCount(std::size_t causes) { return std::log(kCount[std::min(causes, kCount.size() - 1)]); }

std::vector<int> causesOf(const std::vector<ModelTerm>& terms) {
  std::vector<int> causes;
  for (const ModelTerm& term : terms) causes.push_back(term.cause);
  std::ranges::sort(causes);
  return causes;
}

const CompetingModel& modelOfNothing(const DiagnosisWork& work) {
  return *std::ranges::find_if(work.models, [](const CompetingModel& model) { return model.terms.empty(); });
}

std::size_t likelyNoise(const DiagnosisWork& work, const CompetingModel& model) {
  return model.more_noise_probability > 0.5 ? work.noise.size() - 1 : 0;
}

void sortByWeight(std::vector<CompetingModel>& models) {
  std::ranges::stable_sort(
      models, [](const CompetingModel& a, const CompetingModel& b) { return a.logWeight() > b.logWeight(); });
}

}  // namespace tubeplan::calibration
