// What a kind of reading is: what it measures of the tip's place, what its row must state, how it is simulated.
#pragma once

#include <Eigen/Core>

#include "calibration/measurement.hpp"

namespace tubeplan::calibration {

/// A measured value, 1 or 3 rows [m], and how it changes with the tip's place in the world.
using MeasuredValue = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;
using MeasuredSlope = Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 3, 3>;

struct MeasurementKindRow {
  MeasurementKind kind;
  const char* name;  ///< in the column `kind`
  int rows = 3;

  bool is_touch = false;         ///< the tip rests centred at `point`, whose place may be unknown
  bool is_place = false;         ///< p_W is where the tip is
  bool is_displacement = false;  ///< of the loaded tip from its unloaded place at the same joint readings
  bool has_anchor = false;       ///< p_W is a fixed place that it is measured from
  bool has_direction = false;    ///< and direction_W that along which
  bool is_above_zero = false;    ///< a length, which has no sign

  /// Of a tip's place [m] (of a displacement: of the displacement).
  MeasuredValue (*value)(const Measurement& reading, const Eigen::Vector3d& p_W);
  MeasuredSlope (*slope)(const Measurement& reading, const Eigen::Vector3d& p_W);
  /// What was measured; of a touch of an unknown point nothing, whose elimination takes it off.
  MeasuredValue (*measured)(const Measurement& reading);
  /// Writes a simulated value into a reading.
  void (*record)(const MeasuredValue& value, Measurement& reading);
};

}  // namespace tubeplan::calibration
