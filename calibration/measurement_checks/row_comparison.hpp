// Row-by-row comparison of two versions of the measurements, as stated and as corrected, with an arm's predictions. It
// shows at which row a mistake begins.
#pragma once

#include <optional>
#include <vector>

#include "calibration/measurement_checks/mistake.hpp"
#include "calibration/measurements/measurement_prediction.hpp"

namespace tubeplan::calibration {

/// Returns arms with possible base poses: the nominal poses and, if a base is unknown, poses fitted to the first and to
/// the last measurements. A mistake that begins or ends in the middle leaves at least one of these two fits correct.
[[nodiscard]] std::vector<PlacedArm> likelyPlacings(const CheckedMeasurements& checked);

/// Distances between measurements and an arm's predictions, each computed on first use. Arm and measurements must
/// outlive the object.
class RowErrors {
 public:
  RowErrors(const PlacedArm& placed, const std::vector<Measurement>& measurements)
      : placed_(placed), measurements_(measurements), predictor_(placed.arm), known_(measurements.size()) {}

  /// Returns the error of row `k` [m]; NaN if the measurement states no position.
  double at(std::size_t k);

 private:
  [[nodiscard]] double errorOf(std::size_t k);

  const PlacedArm& placed_;
  const std::vector<Measurement>& measurements_;
  MeasurementPredictor predictor_;
  std::vector<std::optional<double>> known_;
};

/// Comparison of the rows as stated with the corrected rows.
class RowComparison {
 public:
  /// Smallest mean of at() over the rows that a mistake affects: the correction must reduce their errors by a factor of
  /// e.
  static constexpr double kLeastMean = 1;

  RowComparison(RowErrors& as_is, RowErrors& corrected, double reach);

  /// Returns the log ratio of the errors of row `k`, as stated to corrected, limited to +-3. The value is positive if
  /// the corrected row fits better, and 0 if the row gives no information.
  double at(std::size_t k);

 private:
  RowErrors &as_is_, &corrected_;
  double blind_;
};

}  // namespace tubeplan::calibration
