#include "calibration/design/next_measurements.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

// A parameter is identifiable if its sigma is below this fraction of its typical size.
constexpr double kIdentifiable = 0.5;

/// Returns the expected measurements of each candidate; empty for a candidate at which the arm's deflected shape does
/// not converge. Unknown points are given names that are unique to each candidate.
std::vector<std::vector<Measurement>> expectedMeasurements(const PlacedArm& placed,
                                                           const std::vector<MeasurementCandidate>& candidates) {
  std::vector<std::vector<Measurement>> expected(candidates.size());
  tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t k) {
    for (const auto& proposed : candidates[k].measurements) {
      auto measurement = expectedMeasurement(placed, proposed);
      if (!measurement) return expected[k].clear();
      if (touchesUnknownPoint(proposed)) measurement->point = "candidate " + std::to_string(k);
      expected[k].push_back(std::move(*measurement));
    }
  });
  return expected;
}

template <class Figure>
double medianOf(const std::vector<Design>& designs, Figure figure) {
  std::vector<double> values;
  for (const auto& design : designs) values.push_back(figure(design));
  return median(std::move(values));
}

double bitsOf(const Design& design) {
  double bits = 0;
  for (const auto& step : design.steps) bits += step.bits;
  return bits;
}

NumberForecast forecast(const Estimate& estimate, std::size_t index, const MatrixXd& now, const Design& design,
                        const std::vector<Design>& random) {
  const auto k = static_cast<Index>(index);
  NumberForecast number;
  number.unknown = estimate.unknowns[index];
  number.value = valueAt(number.unknown, estimate.x[k]);
  const double size = number.unknown.typical * std::abs(slopeAt(number.unknown, estimate.x[k]));
  const double share_now = std::sqrt(now(k, k)), share_after = std::sqrt(design.covariance(k, k));
  number.now = size * share_now;
  number.after = size * share_after;
  const double share_random = medianOf(random, [&](const Design& d) { return std::sqrt(d.covariance(k, k)); });
  number.random = size * share_random;
  number.is_identifiable_now = share_now < kIdentifiable;
  number.is_identifiable_after = share_after < kIdentifiable;
  number.is_identifiable_random = share_random < kIdentifiable;
  return number;
}

}  // namespace

PosedDesign poseDesign(const Estimate& estimate, const std::vector<MeasurementCandidate>& candidates,
                       const Work& work) {
  PosedDesign posed;
  posed.problem.information = estimate.information;
  posed.problem.nuisance_count = static_cast<int>(estimate.nuisance_parameters.root.cols());
  posed.problem.work = tipSensitivities(estimate, work.postures, work.load);
  const PlacedArm placed = placedAsEstimated(estimate);
  const auto expected = expectedMeasurements(placed, candidates);
  std::vector<Measurement> measurements;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    if (expected[k].empty()) continue;
    posed.candidates.push_back(static_cast<int>(k));
    measurements.insert(measurements.end(), expected[k].begin(), expected[k].end());
  }
  const auto weights = weighMeasurements(placed, measurements, {}, estimate.model_error);
  if (!weights) return posed;
  const auto by_variables = sensitivityOf(estimate, measurements, *weights);
  if (!by_variables) return posed;
  std::size_t first = 0;
  for (const int k : posed.candidates) {
    const std::size_t count = candidates[static_cast<std::size_t>(k)].measurements.size();
    Index rows = 0;
    for (std::size_t i = first; i < first + count; ++i) rows += rowsOf(measurements[i]);
    posed.problem.candidates.push_back(by_variables->middleRows(weights->first_row[first], rows));
    first += count;
  }
  return posed;
}

NextMeasurements forecastMeasurements(const Estimate& estimate, const PosedDesign& posed, Design design,
                                      const NextMeasurementsOptions& options) {
  NextMeasurements result;
  result.candidates = posed.candidates;
  result.design = std::move(design);
  if (result.design.status != DesignStatus::kDone) {
    result.status = NextMeasurementsStatus::kTooFewCandidates;
    result.reason = result.design.reason;
    return result;
  }
  const auto& work = posed.problem.work;
  std::vector<Design> random;
  for (const auto& choice :
       drawChoices(static_cast<int>(posed.candidates.size()), static_cast<int>(result.design.steps.size()),
                   options.random_draws, options.seed))
    random.push_back(judgeMeasurements(posed.problem, choice));
  const auto n = estimate.information.rows();
  const MatrixXd now = estimate.information.ldlt().solve(MatrixXd::Identity(n, n));
  for (std::size_t k = 0; k < estimate.unknowns.size(); ++k)
    result.numbers.push_back(forecast(estimate, k, now, result.design, random));
  result.tip_now = tipSigma(work, now);
  result.tip_after = tipSigma(work, result.design.covariance);
  result.tip_random = {medianOf(random, [&](const Design& d) { return tipSigma(work, d.covariance).rms; }),
                       medianOf(random, [&](const Design& d) { return tipSigma(work, d.covariance).worst; })};
  result.bits = bitsOf(result.design);
  result.bits_random = medianOf(random, bitsOf);
  result.status = NextMeasurementsStatus::kDone;
  return result;
}

NextMeasurements proposeMeasurements(const Estimate& estimate, const std::vector<MeasurementCandidate>& candidates,
                                     const Work& work, const NextMeasurementsOptions& options) {
  const PosedDesign posed = poseDesign(estimate, candidates, work);
  return forecastMeasurements(estimate, posed, chooseMeasurements(posed.problem, options.design), options);
}

}  // namespace tubeplan::calibration
