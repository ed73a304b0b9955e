// Measurements as the comma-separated text that readMeasurements reads.
#pragma once

#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/measurement.hpp"
#include "calibration/measurements/proposed_measurement.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

/// The readings in their order, numbers in these units to 12 digits. Columns: id, kind, point, setup, load, a reading
/// for every joint, x, y, z, the kinds' own, tool_x to tool_z, dx, dy, dz, sigma, sigma_x to sigma_z, rho_xy to rho_yz,
/// turn_sigma, from, row, the joints' senses, conditions, split; what no reading has is left out, but for id,
/// kind, point, load, joints, x, y, z, sigma.
[[nodiscard]] std::string measurementsCsv(const std::vector<calibration::Measurement>& readings,
                                          const deflection::Arm& arm, const Units& units);

/// Returns a run sheet: readings to be made, as the same table with nothing in the columns that hold what is measured
/// (calibration/measurements/value_columns.hpp), nor in conditions. Where the joints are that (of a touch),
/// columns near_<joint> say where they will stand.
[[nodiscard]] std::string runSheetCsv(const std::vector<calibration::ProposedMeasurement>& proposed,
                                      const deflection::Arm& arm, const Units& units);

/// Columns of a run sheet that somebody has to fill in for one of its readings.
struct FillIn {
  std::vector<std::string> columns;   ///< of what is measured
  int least = 0;                      ///< of them, without which it is no reading
  std::vector<std::string> optional;  ///< conditions that the readings so far state
};
[[nodiscard]] FillIn fillInOf(const calibration::ProposedMeasurement& proposed, const deflection::Arm& arm,
                              const Units& units);

}  // namespace tubeplan::app
