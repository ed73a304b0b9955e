// Reader of measurement tables: comma-separated text with units in the column names.
#pragma once

#include <string>
#include <vector>

#include "calibration/measurement.hpp"
#include "calibration/measurement_checks/mistake.hpp"
#include "deflection/arm.hpp"
#include "tubesheets/sheet.hpp"

namespace tubeplan::app {

/// Reads the measurements in a file, in file order. Required columns are id, kind and `<joint>_UNIT` for every joint of
/// the arm. Optional columns include point, setup, load_UNIT, x_UNIT, y_UNIT, z_UNIT, distance_UNIT, sigma_UNIT,
/// `<joint>_dir`, CONDITION_UNIT and split (fit, held-out); findColumns() recognises all of them. A touch without
/// coordinates has those of a hole of the sheet if its point is the hole's name (R10C20).
///
/// Throws InputError with line and column. Causes in the table are an unknown, duplicate or missing column, an unknown
/// unit, a number that is invalid or not finite, an unknown kind, and a duplicate id. Causes in the measurements are
/// empty rows of a run sheet, missing or incomplete coordinates, a point that is not on the sheet, and a joint reading
/// beyond its limits.
[[nodiscard]] std::vector<calibration::Measurement> readMeasurements(const std::string& path,
                                                                     const deflection::Arm& arm,
                                                                     const tubesheets::Sheet* sheet = nullptr);

/// Measurements of a table, with the units of the table's columns.
struct MeasurementTable {
  struct JointColumn {
    std::string name, unit;  ///< names of the column and of its unit: "theta1_deg", "deg"
    double factor = 1;       ///< internal units [rad or m] per unit of the column
  };
  std::vector<calibration::Measurement> measurements;
  std::vector<JointColumn> joints;  ///< columns of joint readings, in the order of the arm's joints
  calibration::MeasurementUnits units;
};

/// Parses measurements and the units of their columns; joint readings may be beyond their limits. A relative
/// measurement may also refer to a measurement in `before`. Otherwise throws InputError in the cases of
/// readMeasurements(); messages name the text as `file`.
[[nodiscard]] MeasurementTable parseMeasurementTable(const std::string& text, const std::string& file,
                                                     const deflection::Arm& arm,
                                                     const tubesheets::Sheet* sheet = nullptr,
                                                     const std::vector<calibration::Measurement>& before = {});

/// Throws InputError, with `advice`, for the first joint reading beyond its joint's limits.
void requireWithinLimits(const MeasurementTable& table, const deflection::Arm& arm, const std::string& file,
                         const std::string& advice = "");

/// Returns true if any joint reading is beyond its joint's limits by more than a tolerance for noise.
[[nodiscard]] bool isPastLimits(const calibration::Measurement& measurement, const deflection::Arm& arm);

/// Parses the text of a measurement table as readMeasurements() does; messages name the text as `file`.
[[nodiscard]] std::vector<calibration::Measurement> parseMeasurements(const std::string& text, const std::string& file,
                                                                      const deflection::Arm& arm,
                                                                      const tubesheets::Sheet* sheet = nullptr);

}  // namespace tubeplan::app
