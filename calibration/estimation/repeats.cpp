#include "calibration/estimation/repeats.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double kSameJoint = 2e-3;  // largest difference between joint readings of repeats [rad, m]
constexpr double kSameLoad = 1e-6;   // largest difference between loads of repeats [N]

bool areClose(const VectorXd& a, const VectorXd& b) { return (a - b).lpNorm<Eigen::Infinity>() <= kSameJoint; }

bool areAlike(const Measurement& a, const Measurement& b) {
  const bool same_anchor = kindOf(a).is_place || (a.p_W == b.p_W && a.direction_W == b.direction_W);
  return a.kind == b.kind && a.setup == b.setup && a.point == b.point &&
         a.approach_directions == b.approach_directions && a.reference == b.reference && a.row == b.row &&
         pointOf(a) == pointOf(b) && rowsOf(a) == rowsOf(b) && same_anchor && std::abs(a.load - b.load) <= kSameLoad &&
         a.wrench == b.wrench && areClose(a.q, b.q) && areClose(a.side_q, b.side_q);
}

/// Returns the chi-square of the errors in a group of repeated measurements relative to the weighted mean of these
/// errors.
double scatterOf(const std::vector<int>& members, const MeasurementWeights& weights, const VectorXd& error,
                 Index rows) {
  const auto n = static_cast<Index>(members.size());
  MatrixXd design(n * rows, rows);
  VectorXd whitened(n * rows);
  for (Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(members[static_cast<std::size_t>(i)]);
    design.middleRows(i * rows, rows) = weights.whitener[k];
    whitened.segment(i * rows, rows) = weights.whitener[k] * error.segment(weights.first_row[k], rows);
  }
  return (whitened - design * design.householderQr().solve(whitened)).squaredNorm();
}

}  // namespace

std::vector<int> groupRepeats(const std::vector<Measurement>& measurements) {
  // To avoid comparing all pairs, each measurement is compared only with those whose first joint reading, rounded to a
  // cell, is in the same or a neighbouring cell.
  std::map<std::tuple<std::string, std::string, long>, std::vector<int>> firsts;
  std::vector<int> groups;
  int count = 0;
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    const Measurement& measurement = measurements[k];
    const long cell = measurement.q.size() ? std::lround(measurement.q[0] / (2 * kSameJoint)) : 0;
    int found = -1;
    for (const long near : {cell - 1, cell, cell + 1})
      for (const int first : firsts[{measurement.setup, measurement.point, near}])
        if (areAlike(measurements[static_cast<std::size_t>(first)], measurement) &&
            (found < 0 || groups[static_cast<std::size_t>(first)] < found))
          found = groups[static_cast<std::size_t>(first)];
    if (found < 0) {
      found = count++;
      firsts[{measurement.setup, measurement.point, cell}].push_back(static_cast<int>(k));
    }
    groups.push_back(found);
  }
  return groups;
}

Repeats judgeRepeats(const std::vector<Measurement>& measurements, const MeasurementWeights& weights,
                     const VectorXd& error, double chi2, int freedom) {
  Repeats result;
  std::vector<std::vector<int>> members;
  const std::vector<int> groups = groupRepeats(measurements);
  for (std::size_t k = 0; k < groups.size(); ++k) {
    members.resize(std::max(members.size(), static_cast<std::size_t>(groups[k]) + 1));
    members[static_cast<std::size_t>(groups[k])].push_back(static_cast<int>(k));
  }
  double scatter = 0;
  for (const auto& group : members) {
    if (group.size() < 2) continue;
    const Index rows = rowsOf(measurements[static_cast<std::size_t>(group.front())]);
    scatter += scatterOf(group, weights, error, rows);
    result.pure_freedom += static_cast<int>((static_cast<Index>(group.size()) - 1) * rows);
    result.measurements += static_cast<int>(group.size());
    ++result.groups;
  }
  if (result.groups == 0) return result;
  result.pure_error = scatter;
  result.noise_ratio = std::sqrt(scatter / result.pure_freedom);
  result.noise_p_value = std::min(
      1., 2 * std::min(chiSquareLowerTail(scatter, result.pure_freedom), chiSquareTail(scatter, result.pure_freedom)));
  result.lack_freedom = freedom - result.pure_freedom;
  if (result.lack_freedom < 1 || scatter <= 0) return result;
  const double lack = std::max(0., chi2 - scatter) / result.lack_freedom;
  const double variance = std::min(result.noise_ratio, kMostNoiseRatio) * std::min(result.noise_ratio, kMostNoiseRatio);
  result.lack_of_fit_F = lack / variance;
  result.lack_of_fit_p_value = areBeyondNoise(result)
                                   ? chiSquareTail(lack * result.lack_freedom / variance, result.lack_freedom)
                                   : fisherTail(result.lack_of_fit_F, result.lack_freedom, result.pure_freedom);
  return result;
}

bool disagreesWithStatedNoise(const Repeats& repeats, double level) {
  return repeats.groups > 0 && repeats.noise_p_value < level;
}

}  // namespace tubeplan::calibration
