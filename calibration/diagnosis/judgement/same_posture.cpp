#include "calibration/diagnosis/judgement/same_posture.hpp"

#include <algorithm>
#include <map>

#include "calibration/estimation/repeats.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

using Eigen::Vector3d, Eigen::VectorXd;

namespace {

/// Returns a copy of the measurement without load, wrench, approach directions and point. Copies at the same posture
/// are then equal.
Measurement byPostureAlone(Measurement measurement) {
  measurement.load = 0;
  measurement.wrench = {};
  measurement.approach_directions.clear();
  measurement.point.clear();
  return measurement;
}

/// Returns the errors [m] at each posture with two or more measurements.
std::vector<std::vector<Vector3d>> errorsByPosture(const std::vector<Measurement>& measurements,
                                                   const MeasurementWeights& weights, const VectorXd& whitened) {
  std::vector<Measurement> positions;
  std::vector<Vector3d> errors_of_positions;
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    if (measurements[k].kind != MeasurementKind::kPosition) continue;
    positions.push_back(byPostureAlone(measurements[k]));
    errors_of_positions.emplace_back(
        weights.whitener[k].triangularView<Eigen::Lower>().solve(whitened.segment<3>(weights.first_row[k])));
  }
  const auto group = groupRepeats(positions);
  std::map<int, std::vector<Vector3d>> errors;
  for (std::size_t k = 0; k < positions.size(); ++k) errors[group[k]].push_back(errors_of_positions[k]);
  std::vector<std::vector<Vector3d>> kept;
  for (auto& [index, members] : errors)
    if (members.size() > 1) kept.push_back(std::move(members));
  return kept;
}

Vector3d meanOf(const std::vector<Vector3d>& errors) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& error : errors) mean += error / static_cast<double>(errors.size());
  return mean;
}

}  // namespace

SamePosture judgeSamePosture(const std::vector<Measurement>& measurements, const MeasurementWeights& weights,
                             const VectorXd& whitened) {
  SamePosture result;
  const auto errors = errorsByPosture(measurements, weights, whitened);
  result.postures = static_cast<int>(errors.size());
  if (errors.size() < 2) return result;
  std::vector<Vector3d> all;
  for (const auto& members : errors) all.insert(all.end(), members.begin(), members.end());
  const Vector3d middle = meanOf(all);
  double between = 0, within = 0, squared_counts = 0;
  for (const auto& members : errors) {
    const Vector3d mean = meanOf(members);
    const auto count = static_cast<double>(members.size());
    between += count * (mean - middle).squaredNorm();
    for (const Vector3d& error : members) within += (error - mean).squaredNorm();
    squared_counts += count * count;
  }
  const auto count = static_cast<double>(all.size()), postures = static_cast<double>(errors.size());
  const double above = 3 * (postures - 1), below = 3 * (count - postures);
  between /= above;
  within /= below;
  if (!(within > 0)) return result;
  const double per_posture = (count - squared_counts / count) / (postures - 1);
  const double of_posture = std::max(0., (between - within) / per_posture);
  result.share = of_posture / (of_posture + within);
  result.p_value = fisherTail(between / within, above, below);
  return result;
}

}  // namespace tubeplan::calibration
