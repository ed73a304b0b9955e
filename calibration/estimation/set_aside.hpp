// Setting aside of outliers before a fit, a comparison or a diagnosis. Lists of measurements set aside are ascending
// indices.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

/// Returns the indices of the measurements that are neither held out nor set aside.
[[nodiscard]] std::vector<int> placesFitted(const std::vector<Measurement>& measurements,
                                            const std::vector<int>& set_aside);

/// Returns the number of independent outliers among the measurements set aside. If all touches of an unknown point are
/// set aside, one of them is not counted.
[[nodiscard]] double countOutliers(const std::vector<int>& set_aside, const std::vector<Measurement>& measurements);

/// The measurements set aside as outliers, and the fit of the remaining measurements.
struct WithoutOutliers {
  std::vector<int> set_aside;
  Identification fit;
};

/// Function that fits the same model as the baseline fit to the given measurements, with the given robust loss.
using BaselineFit = std::function<Identification(const std::vector<Measurement>& measurements, RobustLoss loss)>;

/// Finds outliers and fits the remaining measurements. The search is repeated on the remaining measurements, because a
/// large outlier hides a smaller one. If chi-square rejects the baseline fit although it shows no outlier, the outliers
/// of a robust fit are used, because several outliers together can bias a fit so much that no single one stands out.
/// `level` is IdentificationOptions::outlier_level. Empty if there are no outliers, or if more than one measurement in
/// ten is an outlier.
[[nodiscard]] std::optional<WithoutOutliers> withoutOutliers(const std::vector<Measurement>& measurements,
                                                             const Identification& baseline, double level,
                                                             const BaselineFit& fit);

/// Returns the indices of the measurements that withoutOutliers() sets aside; empty if there are no outliers, or too
/// many. `baseline` is the fit to all measurements with `options`, possibly without free parameters.
[[nodiscard]] std::vector<int> measurementsToSetAside(const PlacedArm& start,
                                                      const std::vector<Measurement>& measurements,
                                                      const Identification& baseline,
                                                      const IdentificationOptions& options);

}  // namespace tubeplan::calibration
