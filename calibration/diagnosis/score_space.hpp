// The catalogue's signatures with what the fit could absorb taken off, and the score tests in that space.
//
// With P = I - J (J^T J)^-1 J^T the projection off the fitted unknowns, G = S^T P S and b = S^T P (-r): a set A of
// columns lowers chi-square by T = b_A^T G_AA^-1 b_A at sizes phi = G_AA^-1 b_A (Rao's score test; lavaan's
// modification index and expected parameter change).
#pragma once

#include <cstdint>
#include <vector>

#include "calibration/diagnosis/candidates.hpp"

namespace tubeplan::calibration {

/// One way to say an effect in columns: a candidate at a level, some of its sizes free.
struct Variant {
  int candidate = -1;
  int level = 0;
  std::vector<int> sizes;    ///< indices into the candidate's sizes
  std::vector<int> columns;  ///< of the score space
  int numbers = 0;           ///< that it costs: sizes, and one for a shape
  Eigen::MatrixXd inverse;   ///< of its block of G; empty where that is singular
};

struct Score {
  double fall = 0;        ///< of chi-square; 0 where the sizes are not physical
  Eigen::VectorXd sizes;  ///< in units
  Eigen::VectorXd sigma;  ///< of each, in units
  bool is_physical = true;
};

class ScoreSpace {
 public:
  ScoreSpace() = default;

  /// `jacobian` is that of the fitted unknowns, `r` the whitened residual at the fit.
  ScoreSpace(const Catalogue& catalogue, const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& r);

  [[nodiscard]] const std::vector<Variant>& variants() const { return variants_; }

  /// The score of some variants together.
  [[nodiscard]] Score score(const std::vector<int>& variants) const;

  /// Share of a variant's signature that the fitted unknowns do not absorb, at the sizes that are most visible.
  [[nodiscard]] double keptFraction(int variant) const;

  /// Length of the projected signature per unit of the first size: what one unit would show, in noise sigmas.
  [[nodiscard]] double visibility(int variant) const;

  /// Largest canonical correlation of two variants' projected signatures.
  [[nodiscard]] double correlation(int a, int b) const;

  /// Upper 1 - level quantile for each level, by simulated noise, of the best variant's -log10 p over the whole
  /// catalogue.
  [[nodiscard]] std::vector<double> familyThresholds(const std::vector<double>& levels, int draws,
                                                     std::uint64_t seed) const;

  /// The evidence of one variant alone: -log10 of the p-value of its fall, one-sided where its size has a sign.
  [[nodiscard]] double evidence(int variant, const Score& score) const;

 private:
  [[nodiscard]] bool isPhysical(int column, double size, double sigma) const;
  /// The most of -log10 p over the catalogue at one draw of noise.
  [[nodiscard]] double mostEvidence(const Eigen::VectorXd& b) const;
  [[nodiscard]] double fallAt(const Variant& variant, const Eigen::VectorXd& b) const;
  [[nodiscard]] Score solved(const std::vector<int>& columns, const Eigen::MatrixXd& inverse,
                             const Eigen::VectorXd& b) const;
  [[nodiscard]] bool isOneSided(int variant) const;

  std::vector<Variant> variants_;
  std::vector<double> length_;  ///< of each column before projection
  Eigen::MatrixXd G_;
  Eigen::VectorXd b_;
  std::vector<double> lower_, upper_;  ///< of each column's size, in units
};

}  // namespace tubeplan::calibration
