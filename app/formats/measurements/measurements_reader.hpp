// Reader of measurements: comma-separated text with units in the names of the columns.
#pragma once

#include <string>
#include <vector>

#include "calibration/measurement.hpp"
#include "calibration/measurement_checks/mistake.hpp"
#include "deflection/arm.hpp"
#include "tubesheets/sheet.hpp"

namespace tubeplan::app {

/// Returns the readings of a file, in its order. Columns: id, kind, point, setup, load_UNIT, `<joint>_UNIT` for every
/// joint of the arm, x_UNIT, y_UNIT, z_UNIT, distance_UNIT, sigma_UNIT, `<joint>_dir`, CONDITION_UNIT, split (fit,
/// held-out); only id, kind and the joints are required. A touch without coordinates takes them from the sheet, if its
/// point is a hole's name (R10C20).
///
/// Throws InputError naming the line and column. Reasons are an unknown, double or missing column, an unknown unit, a
/// number that is none or not finite, an unknown kind or a double id. Others are empty rows of a run sheet, missing or
/// incomplete coordinates, a point that is not on the sheet, and a joint reading past its limits.
[[nodiscard]] std::vector<calibration::Measurement> readMeasurements(const std::string& path,
                                                                     const deflection::Arm& arm,
                                                                     const tubesheets::Sheet* sheet = nullptr);

/// Readings with the properties of their columns.
struct MeasurementTable {
  struct JointColumn {
    std::string name, unit;  ///< name of the column and of its unit: "theta1_deg", "deg"
    double factor = 1;       ///< factor to internal units [rad or m per unit]
  };
  std::vector<calibration::Measurement> readings;
  std::vector<JointColumn> joints;  ///< columns of the joints, in the order of the arm
  calibration::ReadingUnits units;
};

/// Returns readings with the units of their columns, including readings past joint limits. Relative readings may also
/// refer to those in `before`. Throws InputError as readMeasurements() does.
[[nodiscard]] MeasurementTable parseMeasurementTable(const std::string& text, const std::string& file,
                                                     const deflection::Arm& arm,
                                                     const tubesheets::Sheet* sheet = nullptr,
                                                     const std::vector<calibration::Measurement>& before = {});

/// Throws InputError, with the advice, for the first joint reading past its limits.
void requireWithinLimits(const MeasurementTable& table, const deflection::Arm& arm, const std::string& file,
                         const std::string& advice = "");

/// Returns true if a joint reading is past its limits by more than its own noise.
[[nodiscard]] bool isPastLimits(const calibration::Measurement& reading, const deflection::Arm& arm);

/// Returns the readings of a text as readMeasurements() does; `file` is its name in messages.
[[nodiscard]] std::vector<calibration::Measurement> parseMeasurements(const std::string& text, const std::string& file,
                                                                      const deflection::Arm& arm,
                                                                      const tubesheets::Sheet* sheet = nullptr);

}  // namespace tubeplan::app
