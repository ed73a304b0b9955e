// Unknown error from a single source: an error of one joint's reading, of the tip or of the base, as a function of one
// quantity that the measurements state. Most errors of machines, known or unknown, are of this form.
//
// Each source is a subset of the terms of the discrepancy process (discrepancy.hpp), and has its own size. Because a
// source has much less freedom than the whole process, far fewer measurements distinguish it from noise and from a
// similar named cause.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

namespace tubeplan::calibration {

/// Evidence of a model with one source added; all sources and sizes are equally probable a priori.
struct SourceEvidence {
  /// Log ratio of the evidence with a source to the evidence without one.
  double log_factor = -std::numeric_limits<double>::infinity();
  int source = -1;          ///< most probable source; -1 if none
  double size = 0;          ///< most probable root-mean-square size of the source [m]
  Eigen::VectorXd weights;  ///< weights of the source's terms, in the order of termsOf(source)
};

/// Inner products of a model's fitted columns W and residual y with the sources' columns.
struct SourceView {
  Eigen::MatrixXd products;  ///< products of each term's column with [W y]
  Eigen::MatrixXd gram;      ///< [W y]^T [W y]
};

class SingleSources {
 public:
  /// `columns` are the whitened columns of the process's terms, `sources` the indices of each source's terms. `shares`
  /// are the fractions of the process's variance due to each term.
  SingleSources(Eigen::MatrixXd columns, std::vector<std::vector<int>> sources, const std::vector<double>& shares);

  /// Returns the inner products of [W y] with the sources' columns: W holds the columns of all fitted parameters, y the
  /// residual without any of these parameters.
  [[nodiscard]] SourceView viewOf(const Eigen::MatrixXd& W_y) const;

  /// Returns the evidence of the model of `view` with one source added. `scale` contains the units of the parameters of
  /// W, `information` the prior information on them in these units, `sizes` the root-mean-square sizes to try for a
  /// source [m].
  [[nodiscard]] SourceEvidence evidenceWithSource(const SourceView& view, const Eigen::VectorXd& scale,
                                                  const Eigen::VectorXd& information, const std::vector<double>& sizes,
                                                  double noise_scale) const;

  /// Returns the whitened errors due to a source with these weights.
  [[nodiscard]] Eigen::VectorXd errorsOf(int source, const Eigen::VectorXd& weights) const;
  [[nodiscard]] const std::vector<int>& termsOf(int source) const { return sources_[static_cast<std::size_t>(source)]; }

 private:
  Eigen::MatrixXd columns_;
  std::vector<std::vector<int>> sources_;
  std::vector<Eigen::MatrixXd> grams_;  ///< Gram matrix of each source's columns
};

}  // namespace tubeplan::calibration
