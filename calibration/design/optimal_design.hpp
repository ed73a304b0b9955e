// Selection of the further measurements that contribute most information to a linear model: greedy selection, then
// exchange of single measurements until no swap improves the result (Fedorov, Theory of Optimal Experiments, 1972).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace tubeplan::calibration {

/// Design problem with n variables, each an unknown divided by its typical size. The last `nuisance_count` of them are
/// nuisance variables: measurements and tip depend on them, but their own accuracy is not an objective.
struct DesignProblem {
  /// Information matrix before the new measurements, n x n, positive definite.
  Eigen::MatrixXd information;
  std::vector<Eigen::MatrixXd> candidates;  ///< whitened Jacobian of each candidate measurement: its number of rows x n
  std::vector<Eigen::MatrixXd> work;        ///< Jacobian of the tip at each work posture, 3 x n [m]
  int nuisance_count = 0;
};

/// Quantity that the chosen measurements minimise.
enum class Optimality {
  kDeterminant,  ///< D: determinant of the covariance, without the nuisance variables
  kWorstTip,     ///< G: variance of the tip at the worst work posture
  kMeanTip,      ///< V: mean variance of the tip over the work postures
};

struct DesignOptions {
  Optimality optimality = Optimality::kDeterminant;
  int count = 10;
  int most_passes = 10;  ///< maximum number of exchange passes, each over all chosen measurements
};

/// Standard deviation of one tip coordinate due to the uncertainty of the variables [m]: root mean square over the work
/// postures, and value at the worst work posture.
struct TipSigma {
  double rms = std::numeric_limits<double>::quiet_NaN();
  double worst = std::numeric_limits<double>::quiet_NaN();
};
[[nodiscard]] TipSigma tipSigma(const std::vector<Eigen::MatrixXd>& work, const Eigen::MatrixXd& covariance);

struct DesignStep {
  int candidate = -1;
  /// Information on the variables, other than nuisance variables, that the candidate adds [bit].
  double bits = std::numeric_limits<double>::quiet_NaN();
  TipSigma tip;          ///< standard deviation of the tip after this step
  int most_helped = -1;  ///< index of the variable whose sigma decreases most, nuisance variables excluded
  /// Sigma of the variable `most_helped` after the step, divided by its sigma before the step; at most 1.
  double helped_by = std::numeric_limits<double>::quiet_NaN();
};

enum class DesignStatus { kNotRun, kDone, kTooFewCandidates };

struct Design {
  DesignStatus status = DesignStatus::kNotRun;
  std::string reason;
  std::vector<DesignStep> steps;  ///< chosen measurements; each one is the best of those not listed before it
  Eigen::MatrixXd covariance;     ///< covariance of the variables after all steps
  int swaps = 0;
};

/// Returns the best `options.count` candidates; none is chosen twice. Swaps are made only if they improve the
/// criterion, so the result is never worse than the greedy choice. For the tip criteria, it is never worse than the
/// choice by determinant either.
[[nodiscard]] Design chooseMeasurements(const DesignProblem& problem, const DesignOptions& options = {});

/// Evaluates a given choice of candidates, in this order, like the choice of chooseMeasurements().
[[nodiscard]] Design judgeMeasurements(const DesignProblem& problem, const std::vector<int>& chosen);

/// Returns `draws` random selections, each of `count` different indices from 0 to candidates - 1.
[[nodiscard]] std::vector<std::vector<int>> drawChoices(int candidates, int count, int draws, std::uint64_t seed);

}  // namespace tubeplan::calibration
