// Choice of the further readings that contribute most information to a linear model: greedy selection, then exchange of
// single readings until no swap helps (Fedorov, Theory of Optimal Experiments, 1972).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace tubeplan::calibration {

/// Design problem with n variables, each an unknown divided by its typical size. The last `beside` variables are
/// nuisance variables: the tip depends on them too, but information on them is not an objective.
struct DesignProblem {
  Eigen::MatrixXd information;              ///< present information matrix, n x n, positive definite
  std::vector<Eigen::MatrixXd> candidates;  ///< whitened Jacobian of each possible reading, rows of the reading x n
  std::vector<Eigen::MatrixXd> work;        ///< Jacobian of the tip at each work posture, 3 x n [m]
  int beside = 0;
};

/// Criterion that the chosen readings minimise.
enum class Optimality {
  kDeterminant,  ///< D: determinant of the covariance, without the nuisance variables
  kWorstTip,     ///< G: variance of the tip at the worst work posture
  kMeanTip,      ///< V: mean variance of the tip over the work postures
};

struct DesignOptions {
  Optimality optimality = Optimality::kDeterminant;
  int count = 10;
  int most_passes = 10;  ///< maximum number of exchange passes, each over all chosen readings
};

/// Standard deviation of a tip coordinate caused by the variables' covariance [m]: root mean square over the work
/// postures, and value at the worst work posture.
struct TipSigma {
  double rms = std::numeric_limits<double>::quiet_NaN();
  double worst = std::numeric_limits<double>::quiet_NaN();
};
[[nodiscard]] TipSigma tipSigma(const std::vector<Eigen::MatrixXd>& work, const Eigen::MatrixXd& covariance);

struct DesignStep {
  int candidate = -1;
  /// Information that the candidate adds on the variables, nuisance variables excepted [bit].
  double bits = std::numeric_limits<double>::quiet_NaN();
  TipSigma tip;          ///< sigma of the tip after this step
  int most_helped = -1;  ///< index of the variable whose sigma falls most, among all but the nuisance variables
  /// Sigma of the variable `most_helped` after the step, divided by its sigma before the step; at most 1.
  double helped_by = std::numeric_limits<double>::quiet_NaN();
};

enum class DesignStatus { kNotRun, kDone, kTooFewCandidates };

struct Design {
  DesignStatus status = DesignStatus::kNotRun;
  std::string reason;
  std::vector<DesignStep> steps;  ///< chosen readings, each the best of the remaining ones by the criterion
  Eigen::MatrixXd covariance;     ///< covariance of the variables after all steps
  int swaps = 0;
};

/// Returns the best readings among the candidates, each at most once. A swap is made only if it improves the choice, so
/// the result is never worse than the greedy choice. By the tip criteria, it is never worse than the choice by
/// determinant either.
[[nodiscard]] Design chooseReadings(const DesignProblem& problem, const DesignOptions& options = {});

/// Evaluates the given readings, in the given order, as chooseReadings() evaluates the readings that it chooses.
[[nodiscard]] Design judgeReadings(const DesignProblem& problem, const std::vector<int>& chosen);

/// Returns `draws` random choices of `count` different indices below `candidates`.
[[nodiscard]] std::vector<std::vector<int>> drawChoices(int candidates, int count, int draws, std::uint64_t seed);

}  // namespace tubeplan::calibration
