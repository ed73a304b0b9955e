// Which of two readings of the same rows an arm fits better, row by row: how a mistake that begins within a table is
// found where it begins.
#pragma once

#include <optional>
#include <vector>

#include "calibration/measurement_checks/mistake.hpp"
#include "calibration/measurements/reading_prediction.hpp"

namespace tubeplan::calibration {

/// Where the bases may be: at their nominal places, and where they are not known as the first or the last readings have
/// them, which are free of a mistake that begins or ends between.
[[nodiscard]] std::vector<PlacedArm> likelyPlacings(const CheckedReadings& checked);

/// How far readings are from where an arm would be, each found when it is first asked for. Arm and readings must
/// outlive it.
class RowErrors {
 public:
  RowErrors(const PlacedArm& placed, const std::vector<Measurement>& readings)
      : placed_(placed), readings_(readings), predictor_(placed.arm), known_(readings.size()) {}

  /// Returns the error of row `k` [m]; not a number of readings that state no place.
  double at(std::size_t k);

 private:
  [[nodiscard]] double errorOf(std::size_t k);

  const PlacedArm& placed_;
  const std::vector<Measurement>& readings_;
  ReadingPredictor predictor_;
  std::vector<std::optional<double>> known_;
};

/// The two readings of the rows, as they are and as a mistake would have them.
class RowComparison {
 public:
  static constexpr double kLeastMean = 1;  ///< of a run that a mistake explains: it changes numbers by more

  RowComparison(RowErrors& as_is, RowErrors& mended, double reach);

  /// Returns the logarithm of the ratio of the errors of row `k`, within 3: above zero where the mended one fits
  /// better, 0 where neither says anything.
  double at(std::size_t k);

 private:
  RowErrors &as_is_, &mended_;
  double blind_;
};

}  // namespace tubeplan::calibration
