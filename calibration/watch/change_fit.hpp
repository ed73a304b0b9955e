// Fit of one candidate change to the measurements since its start, together with the errors of base and parameters.
//
// Minimises -2 log of the posterior density: |x - m|^2 by the covariance of the errors before the start, |t|^2 with the
// numbers t in units of the largest change on real machines, |u|^2 for measured values, and -2 log p for counts of
// steps. For measured values alone the minimum is reached in one step. The deviance of all measurements is that of the
// filter before the start, and from there on this minimum with the errors x integrated out (Laplace's approximation),
// so that fits from different starts are comparable.
#pragma once

#include "calibration/watch/state_filter.hpp"

namespace tubeplan::calibration {

/// Course of a change from its start on.
enum class ChangeCourse {
  kStep,  ///< change that is constant from its start on
  kRamp,  ///< change proportional to the number of measurements since its start
};

/// Returns the part of a change that measurement `k` shows, for a change that begins at `start` and is judged up to
/// `last`: 1 for a step, and growing to 1 for a ramp.
[[nodiscard]] double courseAt(ChangeCourse course, int k, int start, int last);

struct ChangeFit {
  double deviance = 0;          ///< -2 log density of all measurements with the fitted numbers, without constants
  Eigen::VectorXd errors;       ///< errors x of base and parameters
  Eigen::VectorXd numbers;      ///< numbers of the change [ChangeNumber::typical]; for a ramp, those at its end
  Eigen::MatrixXd information;  ///< information on the numbers, their prior included
  double measured_chi2 = 0;     ///< part of the deviance due to measured values and the errors of the base
  int measured_rows = 0;
  double counts_excess = 0;  ///< -2 log p of all counts beyond its mean, in standard deviations; 0 without counts
};

/// Bounds of the numbers of a change [ChangeNumber::typical]; empty if there are none.
struct NumberBounds {
  Eigen::VectorXd lower, upper;
  [[nodiscard]] bool contain(const Eigen::VectorXd& numbers) const {
    return lower.size() == 0 || ((numbers - lower).minCoeff() >= 0 && (upper - numbers).minCoeff() >= 0);
  }
};

/// Fits changes that start at one measurement and follow one course, judged by the measurements up to `last`.
class ChangeFitter {
 public:
  ChangeFitter(const WatchedRows& rows, const ErrorState& before, int start, int last, ChangeCourse course);

  /// Fits the numbers whose columns are `columns`; without columns, there is no change. `near` are start values;
  /// if empty, the fit starts at all values that the counts suggest. Of several minima, the lowest within the bounds
  /// is returned; nullopt if none is within them.
  [[nodiscard]] std::optional<ChangeFit> fit(const std::vector<int>& columns, const NumberBounds& bounds = {},
                                             const Eigen::VectorXd& near = {}) const;

  /// Returns the start from `first` up to `last` at which a change of the fitted numbers, with the same errors, lowers
  /// the deviance most.
  [[nodiscard]] int bestStart(const std::vector<int>& columns, const ChangeFit& fit, int first, int last) const;

 private:
  struct Problem;
  /// Returns the part of the deviance that is due to measurement `k`, for its residual `u`.
  [[nodiscard]] double devianceOf(int k, const Eigen::VectorXd& u) const;
  [[nodiscard]] Problem problemOf(const std::vector<int>& columns) const;
  [[nodiscard]] std::vector<Eigen::VectorXd> startsOf(const Problem& problem) const;
  [[nodiscard]] ChangeFit resultOf(const Problem& problem, const Eigen::VectorXd& y) const;

  const WatchedRows& rows_;
  int start_, last_;
  ChangeCourse course_;
  double before_;  // deviance before the start, plus the log determinant of the errors' covariance there
  Eigen::VectorXd mean_;
  Eigen::MatrixXd prior_;        // information on x before the start
  Eigen::MatrixXd measured_xx_;  // information on x since the start by measured values
  double reach_ = 0;             // mean counted offset since the start [standard deviations]; 0 without counts
};

}  // namespace tubeplan::calibration
