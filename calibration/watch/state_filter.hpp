// Filter of the errors of base and parameters while nothing changes, and the watch over counts of steps.
//
// Measured values update the normal distribution of the errors exactly (Kalman filter). A count updates it to the
// normal distribution with the same mean and covariance as the exact one (assumed density filter).
//
// The watch compares the probability of each count by this filter with its probability if every offset had an
// additional normal error since some visit s. With weights for s and for the error's size that sum to 1 over all
// planned visits, the weighted sum M of these ratios has a mean of at most 1 as long as nothing changes, so that M
// exceeds 1/a at any time with a probability of at most a (Ville's inequality).
#pragma once

#include <Eigen/Cholesky>
#include <array>
#include <vector>

#include "calibration/watch/watched_rows.hpp"

namespace tubeplan::calibration {

/// Mean and covariance of the errors x of base and parameters, after some measurements.
struct ErrorState {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
  double deviance = 0;  ///< -2 log of the predictive density of these measurements, without constants
};

/// Returns the log determinant of a factorised matrix.
[[nodiscard]] inline double logDeterminant(const Eigen::LLT<Eigen::MatrixXd>& factors) {
  return 2 * factors.matrixLLT().diagonal().array().log().sum();
}

/// Probability of a count if nothing changed, and if its offset has an additional error of each size in kSpreads.
inline constexpr std::array kSpreads{1e-4, 2e-4, 5e-4, 1e-3, 2e-3};  ///< standard deviation per coordinate [m]
struct CountChances {
  double unchanged = 1;
  std::array<double, kSpreads.size()> spread{};
};

/// Share of counts that are blunders: no count is less probable than this.
inline constexpr double kBlunder = 1e-6;

class StateFilter {
 public:
  explicit StateFilter(const WatchedRows& rows);

  /// Updates the state by measurement `k`. Returns the predictive probabilities of a count.
  CountChances add(int k);

  [[nodiscard]] const ErrorState& state() const { return state_; }

 private:
  CountChances addCount(int k);

  const WatchedRows& rows_;
  ErrorState state_;
};

class CountWatch {
 public:
  explicit CountWatch(int planned) : log_weight_(-std::log(planned * static_cast<double>(kSpreads.size()))) {
    sums_.fill(-std::numeric_limits<double>::infinity());
  }

  /// Takes the chances of the count at measurement `k` into account; returns log M.
  double add(int k, const CountChances& chances);

  /// Returns the measurement since which the counts are explained best by an additional error.
  [[nodiscard]] int since() const { return since_[best_]; }

 private:
  double log_weight_;                           // log weight of one pair of start and size
  std::array<double, kSpreads.size()> sums_{};  // log of the sum over starts for each size
  std::array<double, kSpreads.size()> rise_{};  // log ratio since the best start
  std::array<int, kSpreads.size()> since_{};
  std::size_t best_ = 0;
};

}  // namespace tubeplan::calibration
