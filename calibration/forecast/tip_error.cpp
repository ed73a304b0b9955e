#include "calibration/forecast/tip_error.hpp"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd;

namespace {

/// A possible variance of the model error, and its probability.
struct ModelVariance {
  double weight = 1, variance = 0;
};

std::vector<ModelVariance> modelVariances(const std::optional<StatedModelError>& error) {
  // Number of equally probable parts into which the distribution is divided; each is represented by its median.
  constexpr int kParts = 8;
  if (!error) return {{1, 0}};
  const double variance = error->sigma * error->sigma;
  const int freedom = error->degrees_of_freedom;
  if (freedom == 0 || variance == 0) return {{1, variance}};
  std::vector<ModelVariance> parts;
  for (int k = 0; k < kParts; ++k)
    parts.push_back({1. / kParts, variance * freedom / chiSquareQuantile((k + 0.5) / kParts, freedom)});
  return parts;
}

PredictionRequest byEverything(const std::vector<Unknown>& numbers) {
  PredictionRequest request;
  request.by_base = request.by_joints = true;
  for (const auto& number : numbers) request.numbers.push_back(deflection::Variable::number(number.path));
  return request;
}

/// Returns the Jacobian of the tip with respect to base and parameters, 3 x (6 + n).
MatrixXd slopesOf(const Prediction& tip, const std::vector<Unknown>& numbers) {
  const auto n = static_cast<Index>(numbers.size());
  MatrixXd slopes(3, 6 + n);
  slopes.leftCols(6) = tip.by_base;
  for (Index k = 0; k < n; ++k)
    slopes.col(6 + k) = tip.by_numbers.col(k) * slopeAt(numbers[static_cast<std::size_t>(k)], 0);
  return slopes;
}

}  // namespace

std::vector<std::vector<TipErrorCase>> findTipError(const TipErrorQuestion& question) {
  const auto& [numbers, covariance] = question.uncertainty;
  const auto parts = modelVariances(question.model_error);
  const auto request = byEverything(numbers);
  const Eigen::Vector3d gravity_B = deflection::gravityInBase(question.arm, question.X_WB);
  oneapi::tbb::enumerable_thread_specific<std::unique_ptr<MeasurementPredictor>> of_thread(
      [&] { return std::make_unique<MeasurementPredictor>(question.arm); });
  std::vector<std::vector<TipErrorCase>> errors(question.postures.size());
  oneapi::tbb::parallel_for(std::size_t{0}, errors.size(), [&](std::size_t k) {
    const Prediction tip =
        of_thread.local()->predictTip(question.X_WB, {question.postures[k], question.load, gravity_B}, request);
    if (!tip.ok) return;
    const MatrixXd slopes = slopesOf(tip, numbers);
    const Eigen::Matrix3d known =
        slopes * covariance * slopes.transpose() + encoderCovariance(question.arm, tip.by_joints);
    for (const auto& part : parts)
      errors[k].push_back({part.weight, known.topLeftCorner<2, 2>() + part.variance * Eigen::Matrix2d::Identity()});
  });
  return errors;
}

}  // namespace tubeplan::calibration
