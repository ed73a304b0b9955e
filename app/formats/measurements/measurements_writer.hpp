// Writer of measurements in the format of readMeasurements().
#pragma once

#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/measurement.hpp"
#include "calibration/measurements/proposed_measurement.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

/// Returns the readings in their order, numbers in these units to 12 digits. Columns: id, kind, point, setup, load, a
/// reading for every joint, x, y, z, the kinds' own, tool_x to tool_z, dx, dy, dz, sigma, sigma_x to sigma_z, rho_xy to
/// rho_yz, turn_sigma, from, row, the joints' senses, conditions, split. Empty columns are left out, except id, kind,
/// point, load, joints, x, y, z and sigma.
[[nodiscard]] std::string measurementsCsv(const std::vector<calibration::Measurement>& readings,
                                          const deflection::Arm& arm, const Units& units);

/// Returns a run sheet: the table of proposed readings, with empty columns for the measured values
/// (calibration/measurements/value_columns.hpp) and for conditions. If the joints are measured (in a touch), columns
/// near_<joint> have their expected values.
[[nodiscard]] std::string runSheetCsv(const std::vector<calibration::ProposedMeasurement>& proposed,
                                      const deflection::Arm& arm, const Units& units);

/// Columns of a run sheet to fill in for one of its readings.
struct FillIn {
  std::vector<std::string> columns;   ///< columns of measured values
  int least = 0;                      ///< minimum number of filled columns for a valid reading
  std::vector<std::string> optional;  ///< columns of conditions that the readings so far state
};
[[nodiscard]] FillIn fillInOf(const calibration::ProposedMeasurement& proposed, const deflection::Arm& arm,
                              const Units& units);

}  // namespace tubeplan::app
