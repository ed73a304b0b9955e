// Which further readings determine the most of a linear model: greedy choice, then exchange of one for another until no
// swap helps (Fedorov, Theory of Optimal Experiments, 1972).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace tubeplan::calibration {

/// Variables are unknowns over their typical sizes, n of them. The last `beside` are uncertain beside the others: the
/// tip hangs on them too, but what readings tell of them is no goal.
struct DesignProblem {
  Eigen::MatrixXd information;              ///< n x n, what is known already; positive definite
  std::vector<Eigen::MatrixXd> candidates;  ///< of each possible reading: whitened sensitivity, its rows x n
  std::vector<Eigen::MatrixXd> work;        ///< of the tip at each work posture: 3 x n [m]
  int beside = 0;
};

/// What a choice is to be best in.
enum class Optimality {
  kDeterminant,  ///< D: the smallest determinant of the covariance but for the variables beside, that is of doubt
  kWorstTip,     ///< G: the least variance of the tip at the worst of the work postures
  kMeanTip,      ///< V: the least mean variance of the tip over the work postures
};

struct DesignOptions {
  Optimality optimality = Optimality::kDeterminant;
  int count = 10;
  int most_passes = 10;  ///< of exchange, each through the whole choice
};

/// Sigma of a tip coordinate that the variables' covariance makes [m]: root mean square over the work postures, and at
/// the worst of them.
struct TipSigma {
  double rms = std::numeric_limits<double>::quiet_NaN();
  double worst = std::numeric_limits<double>::quiet_NaN();
};
[[nodiscard]] TipSigma tipSigma(const std::vector<Eigen::MatrixXd>& work, const Eigen::MatrixXd& covariance);

struct DesignStep {
  int candidate = -1;
  double bits =
      std::numeric_limits<double>::quiet_NaN();  ///< that it adds to what is known, but of the variables beside
  TipSigma tip;                                  ///< after it
  int most_helped = -1;                          ///< the variable, none beside, whose sigma falls most
  double helped_by = std::numeric_limits<double>::quiet_NaN();  ///< that factor, at most 1
};

enum class DesignStatus { kNotRun, kDone, kTooFewCandidates };

struct Design {
  DesignStatus status = DesignStatus::kNotRun;
  std::string reason;
  std::vector<DesignStep> steps;  ///< each the best of those that are left, by the same optimality
  Eigen::MatrixXd covariance;     ///< after all of them
  int swaps = 0;
};

/// The best readings of the candidates, each at most once. A swap is made only where it helps, so exchange never ends
/// worse than the greedy choice; nor does a choice for the tip end worse than the one for the determinant.
[[nodiscard]] Design chooseReadings(const DesignProblem& problem, const DesignOptions& options = {});

/// The same figures for a given choice, in its order.
[[nodiscard]] Design judgeReadings(const DesignProblem& problem, const std::vector<int>& chosen);

/// `draws` random choices of `count` different ones of `candidates`.
[[nodiscard]] std::vector<std::vector<int>> drawChoices(int candidates, int count, int draws, std::uint64_t seed);

}  // namespace tubeplan::calibration
