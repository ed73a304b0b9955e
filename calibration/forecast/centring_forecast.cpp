#include "calibration/forecast/centring_forecast.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "calibration/estimation/estimate.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/random_stream.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

/// The uncertain parameters, as variables that are 0 at the fit, and the covariance of the variables divided by their
/// typical sizes.
struct Uncertain {
  Estimate about;
  MatrixXd covariance;
};

void append(const std::vector<Unknown>& unknowns, MatrixXd covariance, Uncertain& uncertain) {
  for (Index i = 0; i < covariance.rows(); ++i) {
    const double typical = unknowns[static_cast<std::size_t>(i)].typical;
    covariance.row(i) /= typical;
    covariance.col(i) /= typical;
  }
  const Index before = uncertain.covariance.rows(), added = covariance.rows();
  MatrixXd joint_covariance = MatrixXd::Zero(before + added, before + added);
  joint_covariance.topLeftCorner(before, before) = uncertain.covariance;
  joint_covariance.bottomRightCorner(added, added) = covariance;
  uncertain.covariance = joint_covariance;
  uncertain.about.unknowns.insert(uncertain.about.unknowns.end(), unknowns.begin(), unknowns.end());
}

/// Returns the six unknowns of the last base pose: three shifts, then three rotations.
std::vector<Unknown> baseUnknowns(const PlacedArm& placed) {
  PlacedArm last = placed;
  for (auto& base_pose : last.base_poses) base_pose.is_known = true;
  last.base_poses.back().is_known = false;
  return chooseUnknowns(last, {{}, true}).list;
}

Uncertain uncertainOf(const Identification& fit, const CentringForecastOptions& options) {
  Uncertain uncertain;
  uncertain.about.start = fit.fitted;
  const auto fitted = fittedUnknowns(fit);
  if (!fitted.empty()) append(fitted, fit.covariance, uncertain);
  if (options.base_covariance && fit.fitted.base_poses.back().is_known)
    append(baseUnknowns(fit.fitted), *options.base_covariance, uncertain);
  uncertain.about.x = VectorXd::Zero(static_cast<Index>(uncertain.about.unknowns.size()));
  return uncertain;
}

/// Returns the `share` quantile of the values.
double quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(std::lround(share * static_cast<double>(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

ForecastFigure figureOf(const std::vector<double>& of_draws) {
  return {quantile(of_draws, 0.5), quantile(of_draws, 0.025), quantile(of_draws, 0.975)};
}

/// Returns the derivatives of the lateral errors of all postures, two rows per posture, with respect to independent
/// standard normal variables.
MatrixXd sidewaysErrors(const Uncertain& uncertain, const std::vector<VectorXd>& postures, double load) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> axes(uncertain.covariance);
  const VectorXd spread = axes.eigenvalues().cwiseMax(0).cwiseSqrt();
  const MatrixXd root = axes.eigenvectors() * spread.asDiagonal();
  MatrixXd errors(2 * static_cast<Index>(postures.size()), root.cols());
  const auto sensitivities = tipSensitivities(uncertain.about, postures, load);
  for (std::size_t k = 0; k < postures.size(); ++k)
    errors.middleRows(2 * static_cast<Index>(k), 2) = sensitivities[k].topRows(2) * root;
  return errors;
}

void drawErrors(const MatrixXd& errors, const CentringForecastOptions& options, CentringForecast& forecast) {
  RandomStream random(options.seed);
  std::vector<double> medians, tails, worsts;
  VectorXd z(errors.cols());
  for (int draw = 0; draw < options.draws; ++draw) {
    for (double& component : z) component = random.normal(1);
    const VectorXd off = errors * z;
    std::vector<double> lengths;
    for (Index k = 0; k < off.size(); k += 2) lengths.push_back(std::hypot(off[k], off[k + 1]));
    medians.push_back(quantile(lengths, 0.5));
    tails.push_back(quantile(lengths, 0.95));
    worsts.push_back(*std::max_element(lengths.begin(), lengths.end()));
  }
  forecast.median = figureOf(medians);
  forecast.p95 = figureOf(tails);
  forecast.worst = figureOf(worsts);
}

int worstPosture(const MatrixXd& errors) {
  int worst = 0;
  double largest = -1;
  for (Index k = 0; k < errors.rows(); k += 2)
    if (const double size = errors.middleRows(k, 2).squaredNorm(); size > largest) {
      largest = size;
      worst = static_cast<int>(k / 2);
    }
  return worst;
}

EncoderShare encoderShare(const PlacedArm& placed, const std::vector<VectorXd>& postures, double load) {
  std::vector<double> sizes;
  const Eigen::Matrix<double, 6, 6> exact_base = Eigen::Matrix<double, 6, 6>::Zero();
  for (const auto& q : postures) {
    const auto tip = predictTip(placed.arm, placed.base_poses.back().X_WB, q, load);
    sizes.push_back(std::sqrt(tipCovariance(placed.arm, tip, exact_base).topLeftCorner<2, 2>().trace()));
  }
  return {quantile(sizes, 0.5), quantile(sizes, 0.95), *std::max_element(sizes.begin(), sizes.end())};
}

}  // namespace

CentringForecast forecastCentring(const Identification& fit, const std::vector<VectorXd>& postures,
                                  const CentringForecastOptions& options) {
  CentringForecast forecast;
  if (postures.empty()) return forecast;
  forecast.encoders = encoderShare(fit.fitted, postures, options.load);
  const Uncertain uncertain = uncertainOf(fit, options);
  forecast.numbers = static_cast<int>(uncertain.about.unknowns.size());
  if (forecast.numbers == 0) {
    forecast.status = CentringForecastStatus::kNothingUncertain;
    forecast.reason = "nothing was fitted, and the base pose is taken as exact";
    return forecast;
  }
  const MatrixXd errors = sidewaysErrors(uncertain, postures, options.load);
  forecast.worst_posture = worstPosture(errors);
  drawErrors(errors, options, forecast);
  forecast.status = CentringForecastStatus::kDone;
  return forecast;
}

}  // namespace tubeplan::calibration
