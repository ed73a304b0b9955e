#include "calibration/diagnosis/same_posture.hpp"

#include <algorithm>
#include <map>

#include "calibration/estimation/repeats.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

using Eigen::Vector3d, Eigen::VectorXd;

namespace {

/// As if all were made under one load and from one direction: what is left to tell them apart is the posture.
std::vector<Measurement> byPostureAlone(std::vector<Measurement> readings) {
  for (Measurement& reading : readings) {
    reading.load = 0;
    reading.wrench = {};
    reading.approach_directions.clear();
    reading.point.clear();
  }
  return readings;
}

/// Errors [m] at each posture that was kept for two readings or more.
std::vector<std::vector<Vector3d>> errorsByPosture(const std::vector<Measurement>& readings,
                                                   const ReadingWeights& weights, const VectorXd& whitened) {
  const auto group = groupRepeats(byPostureAlone(readings));
  std::map<int, std::vector<Vector3d>> errors;
  for (std::size_t k = 0; k < readings.size(); ++k) {
    if (readings[k].kind != MeasurementKind::kPosition || rowsOf(readings[k]) != 3) continue;
    const VectorXd own = whitened.segment(weights.first_row[k], 3);
    errors[group[k]].emplace_back(weights.whitener[k].partialPivLu().solve(own));
  }
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

SamePosture judgeSamePosture(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                             const VectorXd& whitened) {
  SamePosture result;
  const auto errors = errorsByPosture(readings, weights, whitened);
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
