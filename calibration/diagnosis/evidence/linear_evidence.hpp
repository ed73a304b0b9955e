// The evidence of hypotheses that are linear about one model: the probability of the readings, every number integrated
// over its prior.
//
// About a fitted model a hypothesis says y = J d + S p + s Z g + e: y what the model misses, whitened; d changes of the
// fitted numbers, p the sizes of causes, g the weights of the discrepancy (discrepancy.hpp), all normal; s the
// discrepancy's size, e the noise. With C = I + J P J^T + S V S^T + s^2 Z Z^T the evidence is the normal density
// N(y; 0, C), summed over a grid of s with its prior: Laplace's approximation, exact where the model is linear (MacKay
// 1992, "Bayesian interpolation"). Everything is done in the Gram matrix of the columns [J S Z y], so that its cost
// does not grow with the readings.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// log(exp(a) + exp(b)).
[[nodiscard]] double logSum(double a, double b);

/// Inner products of the columns [J S Z y] over all readings, and the density of the whitening.
struct EvidenceGram {
  Eigen::Index fitted = 0, causes = 0, discrepancy = 0;  ///< columns of J, S and Z; y is the last
  Eigen::MatrixXd products;
  double log_density = 0;  ///< of the noise at the readings: -1/2 log det(2 pi Lambda)

  void add(const Eigen::MatrixXd& J, const Eigen::MatrixXd& S, const Eigen::MatrixXd& Z, const Eigen::VectorXd& y);
};

struct EvidenceOptions {
  std::vector<double> discrepancies;  ///< m, tried sizes of a discrepancy, above none
  double discrepancy_prior = 0.1;     ///< probability that there is one of all terms
  double source_prior = 0;            ///< probability that there is one of a single source (single_source.hpp)
  std::vector<double> noise_scales;   ///< tried factors on the noise, all alike likely; empty: 1 alone
  double noise_rows = 0;              ///< degrees of freedom that the factor counts for
};

struct Evidence {
  double log = -std::numeric_limits<double>::infinity();
  double discrepancy_probability = 0;  ///< that there is one, given the hypothesis
  double discrepancy = 0;              ///< m, the most probable size; 0: none
  std::size_t level = 0;               ///< of that size, among those tried
  double noise_scale = 1;              ///< the most probable
  double log_none = log;               ///< of `log`, what no discrepancy has
  double none_scale = 1;               ///< the most probable noise scale where there is none
  Eigen::VectorXd sizes, sigma;        ///< of the causes' columns, in units, at those
};

/// What is left where an unknown function of the readings may follow all that it can.
struct RichestFit {
  double chi2 = 0;
  double numbers = 0;  ///< that it takes
};

/// A column with its prior, normal about none; of one sign where it has one.
struct PriorSize {
  int column = -1;
  double sigma = 1;
  int sign = 0;  ///< 1: none or more; -1: none or less
};

/// Returns the sign of a number with these bounds: one of them none where it has any.
[[nodiscard]] inline int signWithin(double lower, double upper) { return lower == 0 ? 1 : upper == 0 ? -1 : 0; }

class LinearEvidence {
 public:
  /// `fitted` are the unknowns of J, 0 where the model was fitted.
  LinearEvidence(const EvidenceGram& gram, const std::vector<Unknown>& fitted, const EvidenceOptions& options);

  /// Of a hypothesis with these causes' columns; an empty one says that nothing named is missing. Over all sizes of the
  /// discrepancy, or none and the one of `level` alone, for a quick look.
  [[nodiscard]] Evidence of(const std::vector<PriorSize>& causes, std::optional<std::size_t> level = {}) const;

  /// How long a column is, in noise sigmas per unit, beyond what the fitted numbers absorb; and what share that is.
  [[nodiscard]] double visibility(int column) const;
  [[nodiscard]] double keptShare(int column) const;

  /// Chi-square of the noise alone less that with these columns at their best sizes, no prior and no discrepancy; 0 of
  /// none.
  [[nodiscard]] double fall(const std::vector<int>& columns) const;

  /// The discrepancy's most probable weight of each of its terms, its size given.
  [[nodiscard]] Eigen::VectorXd discrepancyWeights(const std::vector<PriorSize>& causes, double size) const;

  [[nodiscard]] RichestFit richest() const;

  /// The discrepancy by its principal terms: what takes the columns Z to as many that are square to one another and
  /// stand for all of it, largest first; `most` of them.
  [[nodiscard]] Eigen::MatrixXd principalTerms(Eigen::Index most) const;

  /// Of the readings by their weights, at the most probable fitted numbers.
  [[nodiscard]] double chi2() const { return S_y_.bottomRightCorner<1, 1>()(0, 0); }

 private:
  struct Level {
    double size = 0;  ///< m
    double log_prior = 0;
    double log_det = 0;     ///< of J and Z together
    Eigen::VectorXd taken;  ///< share that the discrepancy takes along each of its axes
    Eigen::MatrixXd along;  ///< [S y] along them, by the root of that share
  };
  struct Solution {
    double log_det = 0, square = 0;  ///< of the causes; what y^T C^-1 y is
    double log_signs = 0;            ///< probability of the signs, over that beforehand
    Eigen::VectorXd sizes, sigma;
  };
  void integrateFitted(const EvidenceGram& gram, const std::vector<Unknown>& fitted);
  void findAxes(const Eigen::MatrixXd& Z_Z, const Eigen::MatrixXd& Z_S_y);
  void listLevels();
  [[nodiscard]] Level levelOf(double size) const;
  [[nodiscard]] Solution solve(const std::vector<PriorSize>& causes, const Level& level) const;
  [[nodiscard]] double logOf(const Solution& solution, const Level& level, double noise_scale) const;

  EvidenceOptions options_;
  double log_density_ = 0, log_det_fitted_ = 0;
  Eigen::MatrixXd S_y_;      ///< Gram of [S y], the fitted numbers integrated out
  Eigen::VectorXd length_;   ///< of each column of S before that
  Eigen::MatrixXd along_;    ///< [S y] along the discrepancy's axes
  Eigen::MatrixXd axes_;     ///< of the discrepancy's terms, one column each
  Eigen::VectorXd squares_;  ///< squared length of the discrepancy along each, of size 1 m
  std::vector<Level> levels_;
};

}  // namespace tubeplan::calibration
