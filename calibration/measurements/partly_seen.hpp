// Functions shared by the kinds whose measurements may state only some of three components.
#pragma once

#include <cmath>

#include "calibration/measurements/measurement_kind.hpp"

namespace tubeplan::calibration::partly_seen {

inline int statedRows(const Measurement& measurement) {
  return 3 - static_cast<int>(measurement.kind_values.array().isNaN().count());
}

/// Returns the rows of the components that the measurement states.
template <class Rows>
Rows stated(const Measurement& measurement, const Rows& all) {
  Rows some(statedRows(measurement), all.cols());
  Eigen::Index row = 0;
  for (Eigen::Index k = 0; k < 3; ++k)
    if (!std::isnan(measurement.kind_values[k])) some.row(row++) = all.row(k);
  return some;
}

/// Returns the values with NaN for the component of index `unmeasured`.
inline Eigen::Vector3d without(Eigen::Vector3d values, Eigen::Index unmeasured) {
  values[unmeasured] = std::numeric_limits<double>::quiet_NaN();
  return values;
}

/// Returns the index of the axis of the tool frame that is most nearly parallel to a direction in the world frame.
inline Eigen::Index axisAlong(const Eigen::Vector3d& direction_W, const ToolPose& tool) {
  Eigen::Index axis = 0;
  (tool.R_WT.transpose() * direction_W).cwiseAbs().maxCoeff(&axis);
  return axis;
}

}  // namespace tubeplan::calibration::partly_seen
