// Choice of the further readings that determine most of a linear model: greedy choice, then exchange of one for another
// until no swap helps (Fedorov, Theory of Optimal Experiments, 1972).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace tubeplan::calibration {

/// Design problem. Its n variables are unknowns over their typical sizes. The last `beside` of them are nuisance
/// variables: the tip depends on them too, but information on them is no goal.
struct DesignProblem {
  Eigen::MatrixXd information;              ///< present information, n x n; positive definite
  std::vector<Eigen::MatrixXd> candidates;  ///< whitened sensitivity of each possible reading, its rows x n
  std::vector<Eigen::MatrixXd> work;        ///< sensitivity of the tip at each work posture, 3 x n [m]
  int beside = 0;
};

/// Criterion of the best choice.
enum class Optimality {
  kDeterminant,  ///< D: smallest determinant of the covariance, without the variables beside
  kWorstTip,     ///< G: least variance of the tip at the worst of the work postures
  kMeanTip,      ///< V: least mean variance of the tip over the work postures
};

struct DesignOptions {
  Optimality optimality = Optimality::kDeterminant;
  int count = 10;
  int most_passes = 10;  ///< passes of exchange, each through the whole choice
};

/// Sigma of a tip coordinate by the variables' covariance [m]: root mean square over the work postures, and at the
/// worst of them.
struct TipSigma {
  double rms = std::numeric_limits<double>::quiet_NaN();
  double worst = std::numeric_limits<double>::quiet_NaN();
};
[[nodiscard]] TipSigma tipSigma(const std::vector<Eigen::MatrixXd>& work, const Eigen::MatrixXd& covariance);

struct DesignStep {
  int candidate = -1;
  double bits = std::numeric_limits<double>::quiet_NaN();  ///< information that it adds, without the variables beside
  TipSigma tip;                                            ///< after this step
  int most_helped = -1;                                    ///< variable, without those beside, whose sigma falls most
  double helped_by = std::numeric_limits<double>::quiet_NaN();  ///< ratio of that sigma after and before, at most 1
};

enum class DesignStatus { kNotRun, kDone, kTooFewCandidates };

struct Design {
  DesignStatus status = DesignStatus::kNotRun;
  std::string reason;
  std::vector<DesignStep> steps;  ///< each the best of those left, by the same optimality
  Eigen::MatrixXd covariance;     ///< after all steps
  int swaps = 0;
};

/// Returns the best readings of the candidates, each at most once. A swap is made only if it helps, so that exchange is
/// never worse than the greedy choice; nor is a choice for the tip worse than the one for the determinant.
[[nodiscard]] Design chooseReadings(const DesignProblem& problem, const DesignOptions& options = {});

/// Returns the same figures for a given choice, in its order.
[[nodiscard]] Design judgeReadings(const DesignProblem& problem, const std::vector<int>& chosen);

/// Returns `draws` random choices of `count` different ones of `candidates`.
[[nodiscard]] std::vector<std::vector<int>> drawChoices(int candidates, int count, int draws, std::uint64_t seed);

}  // namespace tubeplan::calibration
