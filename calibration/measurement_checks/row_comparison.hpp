// Row-by-row comparison of two versions of the readings with an arm, which finds the row where a mistake begins.
#pragma once

#include <optional>
#include <vector>

#include "calibration/measurement_checks/mistake.hpp"
#include "calibration/measurements/reading_prediction.hpp"

namespace tubeplan::calibration {

/// Returns possible bases: the nominal ones and, for unknown ones, those fitted to the first and to the last readings,
/// which precede or follow a mistake in the middle.
[[nodiscard]] std::vector<PlacedArm> likelyPlacings(const CheckedReadings& checked);

/// Distances of readings from an arm, each computed on first use. Arm and readings must outlive the object.
class RowErrors {
 public:
  RowErrors(const PlacedArm& placed, const std::vector<Measurement>& readings)
      : placed_(placed), readings_(readings), predictor_(placed.arm), known_(readings.size()) {}

  /// Returns the error of row `k` [m]; NaN for readings that state no place.
  double at(std::size_t k);

 private:
  [[nodiscard]] double errorOf(std::size_t k);

  const PlacedArm& placed_;
  const std::vector<Measurement>& readings_;
  ReadingPredictor predictor_;
  std::vector<std::optional<double>> known_;
};

/// Comparison of the rows as stated with the corrected ones.
class RowComparison {
 public:
  /// Least mean over a run that a mistake explains; a mistake changes numbers by more.
  static constexpr double kLeastMean = 1;

  RowComparison(RowErrors& as_is, RowErrors& mended, double reach);

  /// Returns the logarithm of the ratio of the errors of row `k`, limited to 3 in size. It is positive if the corrected
  /// row fits better, and 0 if the row gives no information.
  double at(std::size_t k);

 private:
  RowErrors &as_is_, &mended_;
  double blind_;
};

}  // namespace tubeplan::calibration
