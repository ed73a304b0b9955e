#include "calibration/patterns/joint_equivalents.hpp"

#include <cmath>

#include "calibration/estimation/fit.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

// Smallest squared lever arm of the joints along a direction, as a fraction of the largest one, for which an error
// along the direction is converted to joint angles.
constexpr double kLeastLever = 1e-4;

struct Turned {
  VectorXd correction;
  double chi2 = 0;
  int rank = 0;
};

Turned turned(const MatrixXd& by_joints, const VectorXd& sigma, const VectorXd& error) {
  const MatrixXd scaled = by_joints * sigma.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> spread(scaled * scaled.transpose());
  Turned result{VectorXd::Zero(sigma.size()), 0, 0};
  const double most = spread.eigenvalues().maxCoeff();
  for (Index k = 0; k < error.size(); ++k) {
    const double value = spread.eigenvalues()[k];
    if (value <= kLeastLever * most || value <= 0) continue;
    const VectorXd direction = spread.eigenvectors().col(k);
    const double along = direction.dot(error);
    result.correction -= sigma.asDiagonal() * (scaled.transpose() * direction) * (along / value);
    result.chi2 += along * along / value;
    ++result.rank;
  }
  return result;
}

}  // namespace

JointEquivalents equivalentJoints(const PlacedArm& placed, const std::vector<Measurement>& measurements,
                                  const VectorXd& error) {
  JointEquivalents result;
  result.sigma = encoderSigmas(placed.arm);
  const bool is_stated = result.sigma.size() > 0 && result.sigma.maxCoeff() > 0;
  const VectorXd weight = is_stated ? result.sigma : VectorXd::Ones(result.sigma.size());
  result.corrections.resize(weight.size(), static_cast<Index>(measurements.size()));
  double chi2 = 0;
  Index row = 0;
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    const Prediction prediction = predictMeasurement(placed, measurements[k], {.by_joints = true});
    if (!prediction.ok) return result;
    const Turned equivalent =
        turned(prediction.by_joints.leftCols(weight.size()), weight, error.segment(row, rowsOf(measurements[k])));
    result.corrections.col(static_cast<Index>(k)) = equivalent.correction;
    chi2 += equivalent.chi2;
    result.degrees_of_freedom += equivalent.rank;
    row += rowsOf(measurements[k]);
  }
  result.ok = true;
  result.mean = result.corrections.rowwise().mean();
  const double others = std::max<double>(1, static_cast<double>(measurements.size()) - 1);
  result.spread = ((result.corrections.colwise() - result.mean).rowwise().squaredNorm() / others).cwiseSqrt();
  if (!is_stated) return result;
  result.chi2 = chi2;
  result.p_value = chiSquareTail(chi2, result.degrees_of_freedom);
  return result;
}

}  // namespace tubeplan::calibration
