// An unknown error of one source: of one joint's reading, of the tip or of the base, following one thing that the
// readings state. Most errors of machines are such, known or not.
//
// Each source is a part of the discrepancy's process (discrepancy.hpp) by itself, with a size of its own: it needs far
// less freedom than all of the process, so that an error of one source is distinguished from noise, and from a cause
// with a name that only resembles it, much earlier.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

namespace tubeplan::calibration {

/// Evidence of a model with one source beside it, all sources and sizes alike likely.
struct SourceEvidence {
  double log_factor = -std::numeric_limits<double>::infinity();  ///< over the model's evidence without any
  int source = -1;                                               ///< the most probable
  double size = 0;                                               ///< m, root mean square, its most probable
  Eigen::VectorXd weights;                                       ///< of its terms, in the order of the source's list
};

/// Columns of what a model fits and what it misses, as sources see them.
struct SourceView {
  Eigen::MatrixXd products;  ///< of each term's column with [W y]
  Eigen::MatrixXd gram;      ///< [W y]^T [W y]
};

class SingleSources {
 public:
  /// Whitened columns of the process's terms, and which of them each source has. `shares` of the terms: of the whole
  /// process's variance.
  SingleSources(Eigen::MatrixXd columns, std::vector<std::vector<int>> sources, const std::vector<double>& shares);

  /// Of [W y]: the columns of all that is fitted, and the residual with none of it.
  [[nodiscard]] SourceView viewOf(const Eigen::MatrixXd& W_y) const;

  /// `scale`: of W's columns; `information`: of their numbers in that scale. `sizes` [m] are tried.
  [[nodiscard]] SourceEvidence beside(const SourceView& view, const Eigen::VectorXd& scale,
                                      const Eigen::VectorXd& information, const std::vector<double>& sizes,
                                      double noise_scale) const;

  /// Whitened errors that a source makes with these weights.
  [[nodiscard]] Eigen::VectorXd errorsOf(int source, const Eigen::VectorXd& weights) const;
  [[nodiscard]] const std::vector<int>& termsOf(int source) const { return sources_[static_cast<std::size_t>(source)]; }

 private:
  Eigen::MatrixXd columns_;
  std::vector<std::vector<int>> sources_;
  std::vector<Eigen::MatrixXd> grams_;  ///< of each source's columns
};

}  // namespace tubeplan::calibration
