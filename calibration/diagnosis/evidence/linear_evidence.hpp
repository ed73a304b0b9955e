// Evidence of hypotheses that are linearised about one model: the probability of the measurements with every parameter
// integrated over its prior.
//
// Near a fitted model, a hypothesis predicts y = J d + S p + s Z g + e. Here y is the whitened residual of the model, d
// the change of the fitted parameters, p the coefficients of the causes' columns, g the weights of the discrepancy
// (discrepancy.hpp), all normally distributed with the prior covariances P, V and I. The scalar s is the size of the
// discrepancy, e is the noise. With C = I + J P J^T + S V S^T + s^2 Z Z^T the evidence is the normal density N(y; 0,
// C), summed over a grid of s with its prior. This is Laplace's approximation, exact for a linear model (MacKay 1992,
// "Bayesian interpolation"). All computations use the Gram matrix of the columns [J S Z y], so their cost does not grow
// with the number of measurements.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Returns log(exp(a) + exp(b)).
[[nodiscard]] double logSum(double a, double b);

/// Inner products of the columns [J S Z y] over all measurements, and the log density of the noise.
struct EvidenceGram {
  Eigen::Index fitted = 0, causes = 0, discrepancy = 0;  ///< numbers of columns of J, S and Z; y is the last column
  Eigen::MatrixXd products;
  double log_density = 0;  ///< log normalisation of the noise density at the measurements: -1/2 log det(2 pi Lambda)

  void add(const Eigen::MatrixXd& J, const Eigen::MatrixXd& S, const Eigen::MatrixXd& Z, const Eigen::VectorXd& y);
};

struct EvidenceOptions {
  std::vector<double> discrepancies;  ///< root-mean-square errors to try for a discrepancy [m], excluding zero
  double discrepancy_prior = 0.1;     ///< prior probability of a discrepancy that has all terms
  double source_prior = 0;            ///< prior probability of a discrepancy with only one source (single_source.hpp)
  std::vector<double> noise_scales;   ///< noise scale factors to try, equally probable; empty means only 1
  double noise_rows = 0;              ///< degrees of freedom to which the noise scale factor applies
};

struct Evidence {
  double log = -std::numeric_limits<double>::infinity();
  double discrepancy_probability = 0;  ///< posterior probability of a discrepancy, given the hypothesis
  double discrepancy = 0;              ///< most probable root-mean-square size of the discrepancy [m]; 0 if none
  /// Index of `discrepancy` among the sizes that were tried; 0 if there is no discrepancy.
  std::size_t level = 0;
  double noise_scale = 1;  ///< most probable noise scale factor
  double log_none = log;   ///< log evidence of the case without a discrepancy, including the prior of this case
  double none_scale = 1;   ///< most probable noise scale factor without a discrepancy
  /// Most probable coefficients of the causes' columns and their standard deviations, for the most probable discrepancy
  /// and noise scale factor.
  Eigen::VectorXd sizes, sigma;
};

/// Fit with the largest tried discrepancy, which fits the measurements as closely as any unknown function could.
struct RichestFit {
  double chi2 = 0;
  double numbers = 0;  ///< effective number of parameters
};

/// Column of a cause with the prior of its coefficient: normal about zero, restricted to one sign if `sign` is not 0.
struct PriorSize {
  int column = -1;
  double sigma = 1;
  int sign = 0;  ///< 1 for non-negative values, -1 for non-positive values, 0 for any sign
};

/// Returns the sign to which these bounds restrict a parameter: 1 or -1 if one bound is zero, otherwise 0.
[[nodiscard]] inline int signWithin(double lower, double upper) { return lower == 0 ? 1 : upper == 0 ? -1 : 0; }

class LinearEvidence {
 public:
  /// Integrates the unknowns `fitted`, whose columns are J, out of the Gram matrix; they are zero at the fitted model.
  LinearEvidence(const EvidenceGram& gram, const std::vector<Unknown>& fitted, const EvidenceOptions& options);

  /// Returns the evidence of the hypothesis that these causes are missing; without causes, of the hypothesis that no
  /// known cause is missing. The evidence is summed over all sizes of the discrepancy or, for a quick estimate, over
  /// zero and the size with index `level`.
  [[nodiscard]] Evidence of(const std::vector<PriorSize>& causes, std::optional<std::size_t> level = {}) const;

  /// Returns the length of the component of a column that the fitted parameters do not absorb [noise sigmas per unit].
  [[nodiscard]] double visibility(int column) const;
  /// Returns the fraction of a column's length that the fitted parameters do not absorb.
  [[nodiscard]] double keptShare(int column) const;

  /// Returns the decrease of chi-square due to these columns with their best coefficients, without priors or a
  /// discrepancy; 0 without columns.
  [[nodiscard]] double fall(const std::vector<int>& columns) const;

  /// Returns the most probable weights of the discrepancy's terms for a given size of the discrepancy [m].
  [[nodiscard]] Eigen::VectorXd discrepancyWeights(const std::vector<PriorSize>& causes, double size) const;

  [[nodiscard]] RichestFit richest() const;

  /// Returns the `most` largest principal terms of the discrepancy (terms x principal terms), largest first: the matrix
  /// that maps the columns Z to orthogonal columns which represent the discrepancy.
  [[nodiscard]] Eigen::MatrixXd principalTerms(Eigen::Index most) const;

  /// Returns chi-square of the measurements at the most probable fitted parameters, without causes or a discrepancy.
  [[nodiscard]] double chi2() const { return S_y_.bottomRightCorner<1, 1>()(0, 0); }

 private:
  struct Level {
    double size = 0;  ///< root-mean-square size of the discrepancy [m]
    double log_prior = 0;
    double log_det = 0;     ///< log determinant of the covariance due to J and Z together
    Eigen::VectorXd taken;  ///< fraction of the signal along each axis that the discrepancy absorbs
    Eigen::MatrixXd along;  ///< [S y] along the axes, times the square root of `taken`
  };
  struct Solution {
    double log_det = 0, square = 0;  ///< log determinant due to the causes, and y^T C^-1 y
    double log_signs = 0;            ///< log probability that all signs are as required, relative to the prior
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
  Eigen::MatrixXd S_y_;      ///< Gram matrix of [S y] with the fitted parameters integrated out
  Eigen::VectorXd length_;   ///< length of each column of S before the fitted parameters are integrated out
  Eigen::MatrixXd along_;    ///< [S y] projected on the discrepancy's axes
  Eigen::MatrixXd axes_;     ///< axes in the space of the discrepancy's terms, one column each
  Eigen::VectorXd squares_;  ///< squared length of a discrepancy of 1 m along each axis
  std::vector<Level> levels_;
};

}  // namespace tubeplan::calibration
