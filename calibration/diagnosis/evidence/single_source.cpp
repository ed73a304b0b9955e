#include "calibration/diagnosis/evidence/single_source.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "calibration/diagnosis/evidence/linear_evidence.hpp"
#include "deflection/resized.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

SingleSources::SingleSources(MatrixXd columns, std::vector<std::vector<int>> sources, const std::vector<double>& shares)
    : columns_(std::move(columns)), sources_(std::move(sources)) {
  for (const auto& terms : sources_) {
    double share = 0;
    for (const int term : terms) share += shares[static_cast<std::size_t>(term)];
    for (const int term : terms) columns_.col(term) /= std::sqrt(share);
    const MatrixXd own = columns_(Eigen::all, terms);
    grams_.emplace_back(own.transpose() * own);
  }
}

SourceView SingleSources::viewOf(const MatrixXd& W_y) const {
  return {columns_.transpose() * W_y, W_y.transpose() * W_y};
}

/// Integrates out the parameters of W. For a source's columns Z, A = Z^T Z - Z^T W M^-1 W^T Z with
/// M = W^T W + information, and b = Z^T y - Z^T W M^-1 W^T y. A size s then multiplies the evidence by
/// det(I + s^2 A)^-1/2 exp(s^2 b^T (I + s^2 A)^-1 b / 2).
SourceEvidence SingleSources::evidenceWithSource(const SourceView& view, const VectorXd& scale,
                                                 const VectorXd& information, const std::vector<double>& sizes,
                                                 double noise_scale) const {
  const Index n = scale.size();
  const MatrixXd Z_W = view.products.leftCols(n) * scale.asDiagonal();
  MatrixXd M = scale.asDiagonal() * view.gram.topLeftCorner(n, n) * scale.asDiagonal();
  M.diagonal() += information;
  const Eigen::LDLT<MatrixXd> factor(M);
  const MatrixXd inverse_W_Z = factor.solve(Z_W.transpose());
  const VectorXd inverse_W_y = factor.solve(VectorXd(scale.asDiagonal() * view.gram.topRightCorner(n, 1)));
  const VectorXd lack_of_fit = view.products.col(n) - Z_W * inverse_W_y;
  SourceEvidence best;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t g = 0; g < sources_.size(); ++g) {
    const auto& terms = sources_[g];
    const MatrixXd A = grams_[g] - Z_W(terms, Eigen::all) * inverse_W_Z(Eigen::all, terms);
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(A);
    const VectorXd along = eigen.eigenvectors().transpose() * VectorXd(lack_of_fit(terms));
    const VectorXd lengths = eigen.eigenvalues().cwiseMax(0);
    for (const double size : sizes) {
      const VectorXd variance = (1 + size * size * lengths.array()).matrix();
      const VectorXd weights = size * size * along.cwiseQuotient(variance);
      const double log = along.dot(weights) / (2 * noise_scale * noise_scale) - variance.array().log().sum() / 2;
      best.log_factor = logSum(best.log_factor, log);
      if (!(log > most)) continue;
      most = log;
      best.source = static_cast<int>(g);
      best.size = size;
      deflection::takeSized(best.weights, eigen.eigenvectors() * weights);
    }
  }
  best.log_factor -= std::log(static_cast<double>(std::max<std::size_t>(1, sources_.size() * sizes.size())));
  return best;
}

VectorXd SingleSources::errorsOf(int source, const VectorXd& weights) const {
  return columns_(Eigen::all, termsOf(source)) * weights;
}

}  // namespace tubeplan::calibration
