// Evidence of hypotheses that are linear about one model: the probability of the readings with every number integrated
// over its prior.
//
// About a fitted model a hypothesis says y = J d + S p + s Z g + e. Here y are the whitened errors of the model, d
// changes of the fitted numbers, p the sizes of causes, g the weights of the discrepancy (discrepancy.hpp), all normal.
// The discrepancy's size is s, the noise e. With C = I + J P J^T + S V S^T + s^2 Z Z^T the evidence is the normal
// density N(y; 0, C), summed over a grid of s with its prior: Laplace's approximation, exact for a linear model (MacKay
// 1992, "Bayesian interpolation"). All computations use the Gram matrix of the columns [J S Z y], so their cost does
// not grow with the readings.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Returns log(exp(a) + exp(b)).
[[nodiscard]] double logSum(double a, double b);

/// Inner products of the columns [J S Z y] over all readings, and the density of the whitening.
struct EvidenceGram {
  Eigen::Index fitted = 0, causes = 0, discrepancy = 0;  ///< columns of J, S and Z; y is the last
  Eigen::MatrixXd products;
  double log_density = 0;  ///< log density of the noise at the readings: -1/2 log det(2 pi Lambda)

  void add(const Eigen::MatrixXd& J, const Eigen::MatrixXd& S, const Eigen::MatrixXd& Z, const Eigen::VectorXd& y);
};

struct EvidenceOptions {
  std::vector<double> discrepancies;  ///< tried sizes of a discrepancy [m], without zero
  double discrepancy_prior = 0.1;     ///< probability of a discrepancy of all terms
  double source_prior = 0;            ///< probability of a discrepancy of a single source (single_source.hpp)
  std::vector<double> noise_scales;   ///< tried factors of the noise, equally probable; empty: 1 alone
  double noise_rows = 0;              ///< degrees of freedom that the factor applies to
};

struct Evidence {
  double log = -std::numeric_limits<double>::infinity();
  double discrepancy_probability = 0;  ///< probability of a discrepancy, given the hypothesis
  double discrepancy = 0;              ///< most probable size of the discrepancy [m]; 0: none
  std::size_t level = 0;               ///< index of that size among those tried
  double noise_scale = 1;              ///< most probable noise scale
  double log_none = log;               ///< part of `log` without a discrepancy
  double none_scale = 1;               ///< most probable noise scale without a discrepancy
  /// Sizes of the causes' columns at these values, in units, and their standard deviations.
  Eigen::VectorXd sizes, sigma;
};

/// Fit with an unknown function of the readings that may follow as much as possible.
struct RichestFit {
  double chi2 = 0;
  double numbers = 0;  ///< effective number of parameters
};

/// Column with its prior, normal about zero; limited to one sign if `sign` is not 0.
struct PriorSize {
  int column = -1;
  double sigma = 1;
  int sign = 0;  ///< 1: zero or more; -1: zero or less; 0: any
};

/// Returns the sign of a number with these bounds, one of which is zero if it has a sign.
[[nodiscard]] inline int signWithin(double lower, double upper) { return lower == 0 ? 1 : upper == 0 ? -1 : 0; }

class LinearEvidence {
 public:
  /// Integrates the unknowns `fitted` of J out of the Gram matrix; they are zero at the fitted model.
  LinearEvidence(const EvidenceGram& gram, const std::vector<Unknown>& fitted, const EvidenceOptions& options);

  /// Returns the evidence of a hypothesis with these causes' columns; without any, nothing named is missing. It is
  /// summed over all sizes of the discrepancy, or over none and that of `level` for a quick estimate.
  [[nodiscard]] Evidence of(const std::vector<PriorSize>& causes, std::optional<std::size_t> level = {}) const;

  /// Returns the length of a column beyond what the fitted numbers absorb [noise sigmas per unit].
  [[nodiscard]] double visibility(int column) const;
  /// Returns the share of a column's length that the fitted numbers do not absorb.
  [[nodiscard]] double keptShare(int column) const;

  /// Returns the fall of chi-square with these columns at their best sizes, without priors or discrepancy; 0 without
  /// columns.
  [[nodiscard]] double fall(const std::vector<int>& columns) const;

  /// Returns the most probable weights of the discrepancy's terms for a given size [m].
  [[nodiscard]] Eigen::VectorXd discrepancyWeights(const std::vector<PriorSize>& causes, double size) const;

  [[nodiscard]] RichestFit richest() const;

  /// Returns the `most` largest principal terms of the discrepancy (terms x principal terms): the matrix that takes the
  /// columns Z to orthogonal ones which represent all of it, largest first.
  [[nodiscard]] Eigen::MatrixXd principalTerms(Eigen::Index most) const;

  /// Returns chi-square of the readings by their weights, at the most probable fitted numbers.
  [[nodiscard]] double chi2() const { return S_y_.bottomRightCorner<1, 1>()(0, 0); }

 private:
  struct Level {
    double size = 0;  ///< [m]
    double log_prior = 0;
    double log_det = 0;     ///< log determinant of J and Z together
    Eigen::VectorXd taken;  ///< share that the discrepancy takes along each of its axes
    Eigen::MatrixXd along;  ///< [S y] along the axes, times the root of that share
  };
  struct Solution {
    double log_det = 0, square = 0;  ///< log determinant of the causes; y^T C^-1 y
    double log_signs = 0;            ///< log probability of the signs, relative to the prior
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
  Eigen::MatrixXd S_y_;      ///< Gram matrix of [S y] with the fitted numbers integrated out
  Eigen::VectorXd length_;   ///< length of each column of S, before that integration
  Eigen::MatrixXd along_;    ///< [S y] along the discrepancy's axes
  Eigen::MatrixXd axes_;     ///< axes of the discrepancy's terms, one column each
  Eigen::VectorXd squares_;  ///< squared length of a discrepancy of 1 m along each axis
  std::vector<Level> levels_;
};

}  // namespace tubeplan::calibration
