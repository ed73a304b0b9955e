#include "calibration/estimation/base_calibration.hpp"

#include <algorithm>
#include <cmath>

#include "calibration/estimation/fit.hpp"
#include "calibration/estimation/touch_suspects.hpp"
#include "calibration/measurements/measurement_prediction.hpp"

namespace tubeplan::calibration {

namespace {

using Eigen::Isometry3d, Eigen::Matrix3d, Eigen::MatrixXd, Eigen::Vector3d;

constexpr std::size_t kMostNamed = 3;  // largest number of possibly mistaken holes listed in the reason

BaseStep stepBetween(const Isometry3d& from, const Isometry3d& to) {
  const Eigen::AngleAxisd turn(Matrix3d(to.linear() * from.linear().transpose()));
  BaseStep step;
  step << to.translation() - from.translation(), turn.angle() * turn.axis();
  return step;
}

BaseCalibration refused(std::string reason) {
  BaseCalibration result;
  result.status = CalibrationStatus::kRefused;
  result.reason = std::move(reason);
  return result;
}

void recordResiduals(const TouchFit& fit, const std::vector<Measurement>& touches, BaseCalibration& result) {
  for (std::size_t k = 0; k < touches.size(); ++k)
    result.residuals.push_back({touches[k].id, touches[k].point, fit.error_W.col(static_cast<Eigen::Index>(k)),
                                fit.noise[k].diagonal().cwiseSqrt()});
  result.rms = fit.error_W.norm() / std::sqrt(static_cast<double>(touches.size()));
}

/// Tip position predicted by the arm as described in its file, with its derivatives (3 x k) with respect to the k
/// independent standard normal variables of the uncertain parameters.
struct FiledTip {
  bool ok = false;
  Vector3d p_W = Vector3d::Zero();
  MatrixXd by_numbers;
};

FiledTip filedTip(MeasurementPredictor& predictor, const UncertainNumbers& numbers, const Isometry3d& X_WB,
                  const Measurement& touch) {
  PredictionRequest request;
  for (const auto& unknown : numbers.unknowns) request.numbers.push_back(deflection::Variable::number(unknown.path));
  Prediction tip = predictor.predict(X_WB, touch, request);
  if (!tip.ok) return {};
  for (std::size_t n = 0; n < numbers.unknowns.size(); ++n)
    tip.by_numbers.col(static_cast<Eigen::Index>(n)) *= slopeAt(numbers.unknowns[n], 0);
  return {true, tip.value, numbers.unknowns.empty() ? MatrixXd::Zero(3, 1) : MatrixXd(tip.by_numbers * numbers.root)};
}

/// Records, for every pair of touches of different holes, the distance between the two tip positions as the arm's file
/// predicts them, and the distance between the holes.
void recordDistances(const TouchesToExplain& to_explain, const TouchFit& fit, BaseCalibration& result) {
  const auto& touches = to_explain.touches;
  MeasurementPredictor predictor(to_explain.arm);
  std::vector<FiledTip> tips;
  for (const auto& touch : touches) tips.push_back(filedTip(predictor, to_explain.numbers, fit.X_WB, touch));
  for (std::size_t i = 0; i < touches.size(); ++i)
    for (std::size_t j = i + 1; j < touches.size(); ++j) {
      if (touches[i].point == touches[j].point || !tips[i].ok || !tips[j].ok) continue;
      const Vector3d between = *touches[j].p_W - *touches[i].p_W, along = between.normalized();
      const double numbers = (along.transpose() * (tips[j].by_numbers - tips[i].by_numbers)).squaredNorm();
      const double noise = along.dot((fit.noise[i] + fit.noise[j]) * along);
      result.distances.push_back({touches[i].point, touches[j].point, (tips[j].p_W - tips[i].p_W).norm(),
                                  between.norm(), std::sqrt(noise + numbers)});
    }
}

void recordNumbers(const UncertainNumbers& numbers, const TouchFit& fit, BaseCalibration& result) {
  for (std::size_t n = 0; n < numbers.unknowns.size(); ++n) {
    const auto k = static_cast<Eigen::Index>(n);
    const Unknown &filed = numbers.unknowns[n], &found = fit.uncertainty.numbers[n];
    result.numbers.push_back({filed.name, filed.quantity, filed.start, found.start,
                              numbers.root.row(k).norm() * std::abs(slopeAt(filed, 0)),
                              std::sqrt(fit.uncertainty.covariance(6 + k, 6 + k)) * std::abs(slopeAt(found, 0))});
  }
}

/// Returns true if the lack of fit is too large for noise, uncertain parameters and the usual model error together. The
/// reason then names the holes that may be mistaken.
bool isMistaken(const TouchesToExplain& to_explain, BaseCalibration& result) {
  const double least = to_explain.options.mistaken_hole_p_value;
  if (!(result.p_value < least)) return false;
  const TouchFit tolerant = fitTouches(to_explain.arm, to_explain.numbers, to_explain.touches, to_explain.X_WB,
                                       {to_explain.options.model_sigma, false, to_explain.options.method});
  if (!(tolerant.p_value < least)) return false;
  result.suspects = findMistakenHoles(to_explain, tolerant.chi2);
  result.reason = "the touches fit neither the holes they name nor any of their neighbours";
  if (!result.suspects.empty()) {
    result.reason = "a hole was mistaken for its neighbour: " + result.suspects.front();
    for (std::size_t k = 1; k < std::min(result.suspects.size(), kMostNamed); ++k)
      result.reason += "; or " + result.suspects[k];
  }
  result.status = CalibrationStatus::kRefused;
  return true;
}

}  // namespace

bool isFitRefused(const BaseCalibration& calibration) { return calibration.p_value < kLackOfFit; }

BaseCalibration calibrateBase(const deflection::Arm& arm, const std::vector<Measurement>& touches,
                              const Isometry3d& X_WB_start, const BaseCalibrationOptions& options) {
  if (const std::string problem = findTouchProblem(touches, options); !problem.empty()) return refused(problem);
  const UncertainNumbers numbers = uncertainNumbers(arm, options.arm);
  const TouchFit fit =
      fitTouches(arm, numbers, touches, X_WB_start, {options.model_error, options.finds_model_error, options.method});
  BaseCalibration result;
  static_cast<TouchedBase&>(result) = fit;
  result.from_start = stepBetween(X_WB_start, fit.X_WB);
  if (fit.status != LeastSquaresStatus::kConverged) {
    result.status = CalibrationStatus::kNotConverged;
    result.reason = fit.reason;
    return result;
  }
  const TouchesToExplain to_explain{arm, numbers, touches, fit.X_WB, options};
  recordResiduals(fit, touches, result);
  recordDistances(to_explain, fit, result);
  recordNumbers(numbers, fit, result);
  if (isFitRefused(result) && options.finds_suspects) {
    const OutlierTouch outlier = findOutlierTouch(to_explain);
    result.outlier_touch = outlier.touch;
    result.rms_of_others = outlier.rms_of_others;
    result.suspect_measurements = findSuspectMeasurements(to_explain);
  }
  if (isMistaken(to_explain, result)) return result;
  result.covariance = fit.uncertainty.covariance.topLeftCorner<6, 6>();
  result.status = CalibrationStatus::kDone;
  return result;
}

}  // namespace tubeplan::calibration
