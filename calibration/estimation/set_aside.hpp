// Readings that a fit, a comparison and a diagnosis set aside as outliers, as ascending indices.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

/// Returns the places of the readings that are neither kept out nor set aside.
[[nodiscard]] std::vector<int> placesFitted(const std::vector<Measurement>& readings,
                                            const std::vector<int>& set_aside);

/// Returns how many of these readings must be outliers. If all touches of an unknown point are set aside, one of them
/// counts as good.
[[nodiscard]] double countOutliers(const std::vector<int>& set_aside, const std::vector<Measurement>& readings);

/// The fit of the remaining readings.
struct WithoutOutliers {
  std::vector<int> set_aside;
  Identification fit;
};

/// Function that fits the model as it stands to some of the readings.
using BaselineFit = std::function<Identification(const std::vector<Measurement>& readings, RobustLoss loss)>;

/// Finds outliers and fits the others. The search is repeated on the remaining readings, because a large outlier hides
/// a smaller one. If the baseline fails and names none, the search uses a robust fit, because several outliers pull a
/// plain fit to themselves. `level` is IdentificationOptions::outlier_level. Nothing if there are none, or more than
/// one reading in ten.
[[nodiscard]] std::optional<WithoutOutliers> withoutOutliers(const std::vector<Measurement>& readings,
                                                             const Identification& baseline, double level,
                                                             const BaselineFit& fit);

/// Returns the readings to set aside before a model is fitted or judged, by withoutOutliers(); empty if there are none,
/// or too many. `baseline` is the fit of all readings by `options`, possibly without free numbers.
[[nodiscard]] std::vector<int> readingsToSetAside(const PlacedArm& start, const std::vector<Measurement>& readings,
                                                  const Identification& baseline, const IdentificationOptions& options);

}  // namespace tubeplan::calibration
