// Unknown error of one source: of one joint's reading, of the tip or of the base, as a function of one quantity that
// the readings state. Most errors of machines are of this form, known or not.
//
// Each source is a part of the discrepancy's process (discrepancy.hpp) with its own size. It has much less freedom than
// the whole process. So it is distinguished from noise, and from a similar named cause, with far fewer readings.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

namespace tubeplan::calibration {

/// Evidence of a model with one source beside it; all sources and sizes are equally probable.
struct SourceEvidence {
  double log_factor = -std::numeric_limits<double>::infinity();  ///< log ratio to the model's evidence without a source
  int source = -1;                                               ///< most probable source; -1: none
  double size = 0;                                               ///< most probable size, root mean square [m]
  Eigen::VectorXd weights;  ///< weights of its terms, in the order of the source's list
};

/// Inner products of a model's fitted columns and residual with the sources' columns.
struct SourceView {
  Eigen::MatrixXd products;  ///< products of each term's column with [W y]
  Eigen::MatrixXd gram;      ///< [W y]^T [W y]
};

class SingleSources {
 public:
  /// Takes the whitened columns of the process's terms, and the terms of each source. `shares` are the terms' shares of
  /// the whole process's variance.
  SingleSources(Eigen::MatrixXd columns, std::vector<std::vector<int>> sources, const std::vector<double>& shares);

  /// Returns the view of [W y]: the columns of all fitted numbers, and the residual without any of them.
  [[nodiscard]] SourceView viewOf(const Eigen::MatrixXd& W_y) const;

  /// Returns the evidence with one source beside the view. `scale` are the units of W's columns, `information` is that
  /// of their numbers in these units. `sizes` [m] are the tried sizes.
  [[nodiscard]] SourceEvidence beside(const SourceView& view, const Eigen::VectorXd& scale,
                                      const Eigen::VectorXd& information, const std::vector<double>& sizes,
                                      double noise_scale) const;

  /// Returns the whitened errors of a source with these weights.
  [[nodiscard]] Eigen::VectorXd errorsOf(int source, const Eigen::VectorXd& weights) const;
  [[nodiscard]] const std::vector<int>& termsOf(int source) const { return sources_[static_cast<std::size_t>(source)]; }

 private:
  Eigen::MatrixXd columns_;
  std::vector<std::vector<int>> sources_;
  std::vector<Eigen::MatrixXd> grams_;  ///< Gram matrix of each source's columns
};

}  // namespace tubeplan::calibration
