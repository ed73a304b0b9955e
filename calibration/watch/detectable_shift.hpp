// Smallest sudden shifts of the base that a watch without alarm would probably have detected: the power of its
// tests.
#pragma once

#include "calibration/watch/change_tests.hpp"

namespace tubeplan::calibration {

/// Number of latest measurements within which a shift is to be found.
inline constexpr int kMeasurementsToFind = 20;

/// Returns, for the world's x, y and z axis, the shift [m] since kMeasurementsToFind measurements ago whose expected
/// statistic is at its limit; infinite along an axis that the measurements do not show. `state` is the filter's after
/// the last measurement; `share` and `planned` are those of the tests.
[[nodiscard]] Eigen::Vector3d detectableShift(const RowsAndCandidates& watched, const ErrorState& state, double share,
                                              int planned);

}  // namespace tubeplan::calibration
