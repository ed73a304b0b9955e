#include "calibration/diagnosis/causes/confounding.hpp"

#include <Eigen/SVD>
#include <algorithm>

#include "calibration/diagnosis/causes/signatures.hpp"
#include "calibration/estimation/span.hpp"
#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

using Eigen::MatrixXd, Eigen::VectorXd;

namespace {

/// Signature of a cause, projected orthogonal to the fitted parameters' Jacobian, as an orthonormal basis.
struct Signature {
  double kept = 0;
  MatrixXd basis;
};

Signature signatureOf(const MatrixXd& own, const MatrixXd& others) {
  const MatrixXd remaining = others.size() > 0 ? without(others, own) : own;
  Signature signature;
  if (!(own.norm() > 0)) return signature;
  signature.kept = remaining.norm() / own.norm();
  if (signature.kept > kHardlyKept) signature.basis = spanOf(remaining);
  return signature;
}

/// Returns the squared cosine of the largest principal angle between the spans of two orthonormal bases: 1 if `first`
/// lies in the span of `second`. Returns 0 if `second` has fewer columns.
double shareOf(const MatrixXd& first, const MatrixXd& second) {
  if (first.cols() == 0 || second.cols() < first.cols()) return 0;
  const VectorXd cosines = (second.transpose() * first).jacobiSvd().singularValues();
  return cosines[first.cols() - 1] * cosines[first.cols() - 1];
}

}  // namespace

std::vector<Confounding> findConfounding(const PlacedArm& placed, const std::vector<Measurement>& measurements,
                                         const std::vector<Unknown>& fitted) {
  const auto weights = weighMeasurements(placed, measurements);
  if (!weights) return {};
  const auto catalogue = singleCauses(placed, measurements, fitted, *weights);
  if (!catalogue) return {};
  const auto& causes = catalogue->causes;
  MatrixXd others;
  if (!fitted.empty())
    others = spanOf(whitenedResidual(placed, fitted, measurements, *weights, zerosOf(fitted), true).jacobian);
  std::vector<Signature> signatures;
  for (std::size_t c = 0; c < causes.size(); ++c)
    signatures.push_back(signatureOf(catalogue->columnsOf(c, static_cast<int>(causes[c].levels.size()) / 2), others));
  std::vector<Confounding> found;
  for (std::size_t a = 0; a < causes.size(); ++a) {
    Confounding entry{causes[a].effect, causes[a].at, signatures[a].kept, {}};
    for (std::size_t b = 0; b < causes.size(); ++b) {
      const double share = a == b ? 0 : shareOf(signatures[a].basis, signatures[b].basis);
      if (share >= kConfoundedShare) entry.confounded.push_back({causes[b].effect, causes[b].at, share});
    }
    std::ranges::stable_sort(entry.confounded, std::greater{}, &ConfoundedCause::share);
    found.push_back(std::move(entry));
  }
  return found;
}

}  // namespace tubeplan::calibration
