#include "calibration/estimation/arm_uncertainty.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

using deflection::Parameter, deflection::Quantity;

int firstJointRow(const deflection::Arm& arm) {
  const auto active = deflection::activeRows(arm);
  return active.empty() ? static_cast<int>(arm.rows.size()) : active.front();
}

bool isPlacement(const Parameter& parameter) {
  return parameter.name.find(".dh.") != std::string::npos || parameter.name.find(".origin.") != std::string::npos;
}

/// Returns the standard deviation of a parameter's value [internal units], which depends on the kind of parameter.
double priorSigma(const Parameter& parameter, const deflection::Arm& arm, const ArmUncertainty& by) {
  const double size = std::abs(parameter.value);
  if (parameter.path.effect >= 0) return by.stiffness * size;
  if (isPlacement(parameter) && parameter.path.row <= firstJointRow(arm)) return 0;
  if (parameter.name.starts_with("tool.tip.")) return by.tip;
  if (parameter.name.starts_with("tool.turn.")) return 0;  // the rotation of the tool frame does not move the tip
  switch (parameter.quantity) {
    case Quantity::kTorquePerAngle:
    case Quantity::kLengthToTheFourth:
      return by.stiffness * size;
    case Quantity::kForce:
    case Quantity::kForcePerLength:
      return by.weight * size;
    case Quantity::kAngle:
      return isPlacement(parameter) ? by.axis : by.zero;
    case Quantity::kLength:
      return by.length;
    default:
      return 0;
  }
}

/// Returns a square root of a covariance matrix: R with R R^T = covariance, without columns that are zero.
MatrixXd rootOf(const MatrixXd& covariance) {
  // Eigenvalues below this fraction of the largest are treated as zero, after each parameter is scaled by its standard
  // deviation.
  constexpr double kLeast = 1e-14;
  const VectorXd sigma = covariance.diagonal().cwiseMax(0).cwiseSqrt();
  const VectorXd scale = sigma.unaryExpr([](double s) { return s > 0 ? 1 / s : 0; });
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(MatrixXd(scale.asDiagonal() * covariance * scale.asDiagonal()));
  const Index n = covariance.rows();
  const double least = n ? kLeast * eigen.eigenvalues()[n - 1] : 0;
  const Index first = (eigen.eigenvalues().array() <= least).count();
  return sigma.asDiagonal() * eigen.eigenvectors().rightCols(n - first) *
         eigen.eigenvalues().tail(n - first).cwiseSqrt().asDiagonal();
}

}  // namespace

UncertainNumbers uncertainNumbers(const deflection::Arm& arm, const ArmUncertainty& uncertainty) {
  FreeChoice choice{{}, false, {}};
  std::vector<double> sigmas;
  std::vector<Index> of_covariance;  // rows of the covariance that belong to parameters of this arm
  const auto& determined = uncertainty.determined;
  for (std::size_t k = 0; k < determined.size(); ++k)
    if (deflection::findParameter(arm, determined[k])) {
      choice.names.push_back(determined[k]);
      of_covariance.push_back(static_cast<Index>(k));
    }
  for (const auto& parameter : deflection::parametersOf(arm)) {
    if (std::ranges::find(determined, parameter.name) != determined.end()) continue;
    const double sigma = priorSigma(parameter, arm, uncertainty);
    if (!(sigma > 0)) continue;
    choice.names.push_back(parameter.name);
    sigmas.push_back(sigma);
  }
  PlacedArm placed{arm, {}};
  UncertainNumbers numbers{chooseUnknowns(placed, choice).list, {}};
  const auto together = static_cast<Index>(of_covariance.size()), alone = static_cast<Index>(sigmas.size());
  const MatrixXd root = together ? rootOf(uncertainty.covariance(of_covariance, of_covariance)) : MatrixXd();
  numbers.root = MatrixXd::Zero(together + alone, root.cols() + alone);
  numbers.root.topLeftCorner(root.rows(), root.cols()) = root;
  numbers.root.bottomRightCorner(alone, alone) = VectorXd::Map(sigmas.data(), alone).asDiagonal();
  // `root` still refers to parameter values; dividing by the slope converts it to variables, to first order.
  for (Index k = 0; k < numbers.root.rows(); ++k)
    numbers.root.row(k) /= slopeAt(numbers.unknowns[static_cast<std::size_t>(k)], 0);
  return numbers;
}

}  // namespace tubeplan::calibration
