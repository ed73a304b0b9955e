#include "calibration/diagnosis/judgement/ranking.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "calibration/diagnosis/judgement/claims.hpp"
#include "calibration/estimation/fit.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::VectorXd;

namespace {

constexpr double kNeverSeen = 1e-6;  // smallest visibility of a cause at its largest usual size [noise sigmas]

/// Returns the gain in log evidence needed to make a cause certain (odds of 19 to 1), given its prior and its Occam
/// factor. The prior probabilities of zero causes and of one cause are 0.5 and 0.35.
double logLeastGain(const Cause& cause, double visibility) {
  const double occam = std::log(std::max(1., 0.5 * visibility));
  const double odds = std::log(0.5 / 0.35) - std::log(std::max(1e-12, cause.prior)) + std::log(19.);
  return std::max(0., odds + occam + std::log(static_cast<double>(cause.levels.size())));
}

/// Returns the effects of a term with the parameter values `sizes`, in units of Unknown::typical. In the arm, they come
/// after the first `before` effects.
std::vector<deflection::Effect> effectsAt(const PlacedArm& placed, const ModelTerm& term,
                                          const std::vector<Unknown>& numbers, const VectorXd& sizes,
                                          std::size_t before) {
  const auto chosen = picked(numbers, term.numbers);
  VectorXd x(sizes.size());
  for (std::size_t k = 0; k < chosen.size(); ++k)
    x[static_cast<Index>(k)] =
        std::clamp(sizes[static_cast<Index>(k)] * chosen[k].typical, chosen[k].lower, chosen[k].upper);
  const auto all = applied(placed, chosen, x).arm.effects;
  return {all.begin() + static_cast<std::ptrdiff_t>(before), all.end()};
}

}  // namespace

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
    const auto columns = picked(work.signatures->columnsOf(index, term.level), term.numbers);
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
  std::ranges::stable_sort(result.ranking, [](const RankedEffect& a, const RankedEffect& b) {
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
    // A cause that changes no measurement by more than rounding errors cannot be detected at any size.
    const double units = visibility > kNeverSeen ? sigmas / visibility : std::numeric_limits<double>::infinity();
    result.detectable.push_back({cause.effect, cause.at, number.name.substr(number.name.rfind('.') + 1),
                                 number.quantity, units * number.typical, units > 1});
  }
}

}  // namespace tubeplan::calibration
