#include "calibration/watch/detectable_shift.hpp"

#include <algorithm>
#include <cmath>

namespace tubeplan::calibration {

using Eigen::Index, Eigen::Matrix2d, Eigen::MatrixXd, Eigen::Vector2d, Eigen::VectorXd;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLeastInformation = 1e-9;
constexpr double kSmallest = 1e-5, kLargest = 0.05;  // shifts that are tried where counts find them [m]
constexpr int kHalvings = 12;

/// Returns the shift along an axis that measured values find, for a base with six numbers. The errors of base and
/// parameters have the covariance `state`.
double byValues(const RowsAndCandidates& watched, const ErrorState& state, int first, int axis, double limit) {
  const WatchedRows& rows = watched.rows;
  double jj = 0;
  VectorXd hj = VectorXd::Zero(rows.H.cols());
  MatrixXd hh = state.covariance.llt().solve(MatrixXd::Identity(rows.H.cols(), rows.H.cols()));
  for (int k = first; k < rows.count(); ++k) {
    if (rows.isCounted(k)) continue;
    const auto H = rows.H.middleRows(rows.first(k), rows.rowsOf(k));
    const auto J = rows.changes.col(axis).segment(rows.first(k), rows.rowsOf(k));
    jj += J.squaredNorm();
    hj += H.transpose() * J;
    hh += H.transpose() * H;
  }
  const double information = jj - hj.dot(hh.llt().solve(hj));
  return information > kLeastInformation ? std::sqrt(limit / information) : kInfinity;
}

/// Returns the expected log ratio of the best spread over the latest counts, for a shift along an axis [typical].
double expectedRatio(const RowsAndCandidates& watched, const ErrorState& state, int first, int axis, double shift) {
  const WatchedRows& rows = watched.rows;
  std::array<double, kSpreads.size()> sums{};
  for (int k = first; k < rows.count(); ++k) {
    if (!rows.isCounted(k)) continue;
    const double scale = rows.scale[static_cast<std::size_t>(k)];
    const auto H = rows.H.middleRows<2>(rows.first(k));
    const Vector2d mean = rows.r.segment<2>(rows.first(k)) + H * state.mean;
    const Vector2d shifted = mean + rows.changes.col(axis).segment<2>(rows.first(k)) * shift;
    const Matrix2d S = Matrix2d::Identity() + H * state.covariance * H.transpose();
    const CountedSteps& count = *rows.counted[static_cast<std::size_t>(k)];
    for (int entered = 0; entered < count.outcomes(); ++entered) {
      const double p = probabilityOf(count, entered, shifted, S).p;
      const double unchanged = probabilityOf(count, entered, mean, S).p + kBlunder;
      for (std::size_t s = 0; s < kSpreads.size(); ++s) {
        const Matrix2d wider = S + kSpreads[s] * kSpreads[s] / (scale * scale) * Matrix2d::Identity();
        sums[s] += p * std::log((probabilityOf(count, entered, mean, wider).p + kBlunder) / unchanged);
      }
    }
  }
  return *std::ranges::max_element(sums);
}

double byCounts(const RowsAndCandidates& watched, const ErrorState& state, int first, int axis, double limit) {
  const double typical = watched.candidates.list.front().numbers[static_cast<std::size_t>(axis)].typical;
  const auto ratio = [&](double shift) { return expectedRatio(watched, state, first, axis, shift / typical); };
  if (ratio(kLargest) < limit) return kInfinity;
  double low = kSmallest, high = kLargest;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = std::sqrt(low * high);
    (ratio(middle) < limit ? low : high) = middle;
  }
  return high;
}

}  // namespace

Eigen::Vector3d detectableShift(const RowsAndCandidates& watched, const ErrorState& state, double share, int planned) {
  const int first = std::max(0, watched.rows.count() - kMeasurementsToFind);
  const double tests = planned * static_cast<double>(startsBefore(planned).size());
  const double value_limit = chiSquareQuantile(share / tests, 6);
  const double count_limit = -std::log(share) + std::log(planned * static_cast<double>(kSpreads.size()));
  Eigen::Vector3d shift;
  for (int axis = 0; axis < 3; ++axis) {
    const double typical = watched.candidates.list.front().numbers[static_cast<std::size_t>(axis)].typical;
    shift[axis] = byValues(watched, state, first, axis, value_limit) * typical;
    if (watched.rows.hasCounts())
      shift[axis] = std::min(shift[axis], byCounts(watched, state, first, axis, count_limit));
  }
  return shift;
}

}  // namespace tubeplan::calibration
