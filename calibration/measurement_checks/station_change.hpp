// Search for the measurement from which on a tracker or a base stands elsewhere by any distance and turn. Two rigid
// alignments in closed form, before and after it, need no start value and no small displacement, unlike the steps of
// step_scan.hpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Returns the index of the measurement of `setup` at which a second base pose explains the measured positions best, by
/// the rigid arm of `drawing`. Nullopt if the gain does not outweigh the penalty of such a step, or if there are too
/// few positions.
[[nodiscard]] std::optional<std::size_t> stationChange(const PlacedArm& drawing,
                                                       const std::vector<Measurement>& measurements,
                                                       const std::string& setup);

}  // namespace tubeplan::calibration
