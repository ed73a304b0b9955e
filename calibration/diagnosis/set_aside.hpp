// Readings that a diagnosis sets aside as outliers, by their places in ascending order.
#pragma once

#include <vector>

#include "calibration/measurement.hpp"

namespace tubeplan::calibration {

/// With the touches that are then left alone at a point of unknown place: they determine nothing.
[[nodiscard]] std::vector<int> withOrphans(const std::vector<int>& outliers, const std::vector<Measurement>& readings);

/// How many of these readings must be outliers: of the touches of one unknown point that are all set aside, one is left
/// alone or is as good as the others.
[[nodiscard]] double countOutliers(const std::vector<int>& set_aside, const std::vector<Measurement>& readings);

/// The places of those that are left, out of so many.
[[nodiscard]] std::vector<int> othersThan(const std::vector<int>& set_aside, std::size_t readings);

}  // namespace tubeplan::calibration
