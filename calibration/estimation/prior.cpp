#include "calibration/estimation/prior.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double kSingular = 1e-14;  // eigenvalues below this fraction of the largest are treated as zero

}  // namespace

VectorXd priorSlopes(const std::vector<Unknown>& unknowns) {
  VectorXd slopes(static_cast<Index>(unknowns.size()));
  for (std::size_t k = 0; k < unknowns.size(); ++k) slopes[static_cast<Index>(k)] = 1 / unknowns[k].prior_sigma;
  return slopes;
}

VectorXd priorInformation(const std::vector<Unknown>& unknowns) {
  VectorXd information = zerosOf(unknowns);
  for (std::size_t k = 0; k < unknowns.size(); ++k)
    information[static_cast<Index>(k)] = std::pow(unknowns[k].typical / unknowns[k].prior_sigma, 2);
  return information;
}

VectorXd priorResiduals(const std::vector<Unknown>& unknowns, const VectorXd& x) {
  VectorXd residuals = priorSlopes(unknowns);
  for (std::size_t k = 0; k < unknowns.size(); ++k)
    residuals[static_cast<Index>(k)] *= x[static_cast<Index>(k)] - unknowns[k].prior_mean;
  return residuals;
}

MatrixXd posteriorCovariance(const MatrixXd& jacobian, const std::vector<Unknown>& unknowns) {
  const auto n = static_cast<Index>(unknowns.size());
  if (n == 0) return MatrixXd(0, 0);
  MatrixXd information = MatrixXd::Zero(n, n);
  if (jacobian.rows() > 0) information.selfadjointView<Eigen::Lower>().rankUpdate(jacobian.transpose());
  information.diagonal() += priorSlopes(unknowns).cwiseAbs2();
  // Scale the matrix to a unit diagonal, because compliances and lengths differ by many orders of magnitude.
  const VectorXd scale =
      information.diagonal().unaryExpr([](double value) { return value > 0 ? 1 / std::sqrt(value) : 0; });
  information =
      (scale.asDiagonal() * MatrixXd(information.selfadjointView<Eigen::Lower>()) * scale.asDiagonal()).eval();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(information);
  const double least = kSingular * eigen.eigenvalues()[n - 1];
  const VectorXd inverse = eigen.eigenvalues().unaryExpr([&](double value) { return value > least ? 1 / value : 0; });
  const MatrixXd back = scale.asDiagonal() * eigen.eigenvectors();
  return back * inverse.asDiagonal() * back.transpose();
}

MatrixXd inverseOfInformation(const MatrixXd& information) {
  const VectorXd scale = information.diagonal().cwiseSqrt().cwiseInverse();
  const MatrixXd scaled = scale.asDiagonal() * information * scale.asDiagonal();
  return scale.asDiagonal() * scaled.ldlt().solve(MatrixXd::Identity(scale.size(), scale.size())) * scale.asDiagonal();
}

double effectiveNumbers(const MatrixXd& covariance, const std::vector<Unknown>& unknowns) {
  double numbers = 0;
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    const double variance = covariance(static_cast<Index>(k), static_cast<Index>(k));
    if (variance > 0) numbers += 1 - variance / (unknowns[k].prior_sigma * unknowns[k].prior_sigma);
  }
  return numbers;
}

int numbersDetermined(const MatrixXd& covariance, const std::vector<Unknown>& unknowns) {
  return static_cast<int>(std::lround(effectiveNumbers(covariance, unknowns)));
}

}  // namespace tubeplan::calibration
