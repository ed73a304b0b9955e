#include "calibration/diagnosis/causes/confounding.hpp"

#include <Eigen/SVD>
#include <algorithm>

#include "calibration/diagnosis/causes/signatures.hpp"
#include "calibration/estimation/span.hpp"
#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

/// A cause's signature with what the fitted numbers can do taken off, as an orthonormal basis.
struct Signature {
  double kept = 0;
  MatrixXd basis;
};

Signature signatureOf(const MatrixXd& own, const MatrixXd& others) {
  const MatrixXd left = others.size() > 0 ? without(others, own) : own;
  Signature signature;
  if (!(own.norm() > 0)) return signature;
  signature.kept = left.norm() / own.norm();
  if (signature.kept > kHardlyKept) signature.basis = spanOf(left);
  return signature;
}

/// How much of the one lies in the other, in the direction where it is least.
double shareOf(const MatrixXd& one, const MatrixXd& other) {
  if (one.cols() == 0 || other.cols() < one.cols()) return 0;
  const VectorXd cosines = (other.transpose() * one).jacobiSvd().singularValues();
  return cosines[one.cols() - 1] * cosines[one.cols() - 1];
}

std::vector<Signature> signaturesOf(const std::vector<Cause>& causes, const Signatures& list, const MatrixXd& columns,
                                    const MatrixXd& others) {
  std::vector<Signature> signatures;
  for (std::size_t c = 0; c < causes.size(); ++c) {
    const int level = static_cast<int>(causes[c].levels.size()) / 2;
    signatures.push_back(signatureOf(columns(Eigen::all, list.columnsOf(static_cast<int>(c), level)), others));
  }
  return signatures;
}

}  // namespace

std::vector<Confounding> findConfounding(const PlacedArm& placed, const std::vector<Measurement>& readings,
                                         const std::vector<Unknown>& fitted) {
  const auto weights = weighReadings(placed, readings);
  if (!weights) return {};
  auto causes = listCauses(placed, readings, fitted).causes;
  std::erase_if(causes, [](const Cause& cause) { return cause.effects.size() != 1; });
  const Signatures list(placed, causes);
  const MatrixXd columns = list.columnsAt(readings, *weights);
  if (columns.rows() != weights->rows) return {};
  MatrixXd others;
  if (!fitted.empty())
    others = spanOf(
        whitenedResidual(placed, fitted, readings, *weights, VectorXd::Zero(static_cast<Index>(fitted.size())), true)
            .jacobian);
  const auto signatures = signaturesOf(causes, list, columns, others);
  std::vector<Confounding> found;
  for (std::size_t a = 0; a < causes.size(); ++a) {
    Confounding entry{causes[a].effect, causes[a].at, signatures[a].kept, {}};
    for (std::size_t b = 0; b < causes.size(); ++b) {
      const double share = a == b ? 0 : shareOf(signatures[a].basis, signatures[b].basis);
      if (share >= kConfoundedShare) entry.confounded.push_back({causes[b].effect, causes[b].at, share});
    }
    std::stable_sort(entry.confounded.begin(), entry.confounded.end(),
                     [](const ConfoundedCause& x, const ConfoundedCause& y) { return x.share > y.share; });
    found.push_back(std::move(entry));
  }
  return found;
}

}  // namespace tubeplan::calibration
