// Writer of measurement tables in the format of readMeasurements().
#pragma once

#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/measurement.hpp"
#include "calibration/measurements/proposed_measurement.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

/// Returns the text of a table with the measurements in their order and numbers in `units`, to 12 digits. Columns: id,
/// kind, point, setup, load, force_x to moment_z, a reading for every joint, x, y, z, quantities of particular kinds,
/// tool_x to tool_z, dx, dy, dz, sigma, sigma_x to sigma_z, rho_xy to rho_yz, turn_sigma, from, row, approach
/// directions of the joints, conditions, split. Empty columns are omitted, except id, kind, point, load, joints, x, y,
/// z and sigma.
[[nodiscard]] std::string measurementsCsv(const std::vector<calibration::Measurement>& measurements,
                                          const deflection::Arm& arm, const Units& units);

/// Returns a run sheet: a table of proposed measurements with empty columns for the measured values
/// (calibration/measurements/value_columns.hpp) and for conditions. If the joint readings are to be measured (in a
/// touch), columns `near_<joint>` contain their expected values.
[[nodiscard]] std::string runSheetCsv(const std::vector<calibration::ProposedMeasurement>& proposed,
                                      const deflection::Arm& arm, const Units& units);

/// Columns of a run sheet that are to be filled in for one of the proposed measurements.
struct FillIn {
  std::vector<std::string> columns;   ///< columns of the measured values
  int least = 0;                      ///< minimum number of `columns` that must be filled in for a valid measurement
  std::vector<std::string> optional;  ///< columns of those conditions that earlier measurements state
};
[[nodiscard]] FillIn fillInOf(const calibration::ProposedMeasurement& proposed, const deflection::Arm& arm,
                              const Units& units);

}  // namespace tubeplan::app
