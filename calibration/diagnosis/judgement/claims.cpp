#include "calibration/diagnosis/judgement/claims.hpp"

#include <algorithm>

#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

namespace {

/// Returns the median decrease of log evidence between linearisation and fit, over the fitted models with causes; 0 if
/// the evidence increases.
double lossByFit(const DiagnosisWork& work) {
  std::vector<double> losses;
  for (const CompetingModel& model : work.models)
    if (model.hasFit() && !model.terms.empty()) losses.push_back(-model.gain_by_fit);
  return losses.empty() ? 0 : std::max(0., median(std::move(losses)));
}

}  // namespace

void mergeClaim(const Claim& from, Claim& to) {
  const double both = to.probability + from.probability;
  if (!(both > 0)) return;
  const auto mixed = [&](double a, double b) { return (to.probability * a + from.probability * b) / both; };
  to.remainder_probability = mixed(to.remainder_probability, from.remainder_probability);
  to.scatter_probability = mixed(to.scatter_probability, from.scatter_probability);
  to.probability = both;
}

std::vector<Claim> claimsOf(const DiagnosisWork& work) {
  std::vector<Claim> claims;
  std::vector<double> logs;
  const double loss = lossByFit(work);
  for (const CompetingModel& model : work.models) {
    claims.push_back({causesOf(model.terms), 0, model.discrepancy_probability, model.scatter_probability, &model});
    logs.push_back(model.logWeight() - (model.is_fitted ? 0 : loss));
    for (const Likeness& likeness : model.hasFit() ? model.likenesses : std::vector<Likeness>{}) {
      auto others = model.terms;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(likeness.term));
      claims.push_back({causesOf(others), 0, 1, 0, nullptr});
      logs.push_back(likeness.log_weight);
    }
  }
  const auto probabilities = probabilitiesOf(logs);
  for (std::size_t k = 0; k < claims.size(); ++k) claims[k].probability = probabilities[k];
  return claims;
}

}  // namespace tubeplan::calibration
