#include "calibration/diagnosis/remainder.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "calibration/diagnosis/claims.hpp"
#include "calibration/estimation/fit.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::VectorXd;

SamePosture samePostureBy(const DiagnosisWork& work, const CompetingModel& model) {
  const DiagnosisBasis& basis = work.basis;
  if (model.terms.empty() || !hasFit(model)) return judgeSamePosture(basis.readings, basis.weights, basis.residual.r);
  const auto residual = whitenedResidual(model.fit.fitted, {}, basis.readings, basis.weights, {}, false);
  return residual.ok ? judgeSamePosture(basis.readings, basis.weights, residual.r) : SamePosture{};
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
  const NoiseHypothesis& noise = work.noise[likelyNoise(work, model)];
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
