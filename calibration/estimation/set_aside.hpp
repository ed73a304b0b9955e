// Readings that a fit, a comparison and a diagnosis set aside as outliers, by their places in ascending order.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

/// With the touches that are then left alone at a point of unknown place: they determine nothing.
[[nodiscard]] std::vector<int> withOrphans(const std::vector<int>& outliers, const std::vector<Measurement>& readings);

/// How many of these readings must be outliers: of the touches of one unknown point that are all set aside, one is left
/// alone or is as good as the others.
[[nodiscard]] double countOutliers(const std::vector<int>& set_aside, const std::vector<Measurement>& readings);

/// The fit of the readings that are left.
struct WithoutOutliers {
  std::vector<int> set_aside;
  Identification fit;
};

/// Fits the model as it stands to some of the readings.
using BaselineFit = std::function<Identification(const std::vector<Measurement>& readings, RobustLoss loss)>;

/// Outliers are looked for again in what is left, since a large one hides a smaller one, and by a fit that weighs
/// readings down where the baseline fails and names none: several at once draw it to themselves. `level` is
/// IdentificationOptions::outlier_level. Nothing where there are none, or more than one reading in ten.
[[nodiscard]] std::optional<WithoutOutliers> withoutOutliers(const std::vector<Measurement>& readings,
                                                             const Identification& baseline, double level,
                                                             const BaselineFit& fit);

/// Returns the readings that are set aside before a model is fitted or judged, by withoutOutliers(): empty where there
/// are none, or too many. `baseline` is the fit of all readings by `options`; nothing may have been free.
[[nodiscard]] std::vector<int> readingsToSetAside(const PlacedArm& start, const std::vector<Measurement>& readings,
                                                  const Identification& baseline, const IdentificationOptions& options);

}  // namespace tubeplan::calibration
