// Measurements: comma-separated text whose columns carry their units in their names.
#pragma once

#include <string>
#include <vector>

#include "calibration/measurement.hpp"
#include "calibration/measurement_checks/mistake.hpp"
#include "deflection/arm.hpp"
#include "tubesheets/sheet.hpp"

namespace tubeplan::app {

/// The readings of a file, in its order. Columns: id, kind, point, setup, load_UNIT, `<joint>_UNIT` for every joint of
/// the arm, x_UNIT, y_UNIT, z_UNIT, distance_UNIT, sigma_UNIT, `<joint>_dir`, CONDITION_UNIT, split (fit,
/// held-out); only id, kind and the joints must be there. A touch without coordinates whose point is a hole's name
/// (R10C20) takes them from the sheet, where one is given. Throws InputError naming the line and column for: an
/// unknown, double or missing column, an unknown unit, a number that is none or not finite, an unknown kind, a double
/// id, rows of a run sheet that are not filled in, coordinates that a kind needs or that are given in part, a point
/// that is not on the sheet, a joint reading past its limits.
[[nodiscard]] std::vector<calibration::Measurement> readMeasurements(const std::string& path,
                                                                     const deflection::Arm& arm,
                                                                     const tubesheets::Sheet* sheet = nullptr);

/// Readings with what their columns say of themselves.
struct MeasurementTable {
  struct JointColumn {
    std::string name, unit;  ///< "theta1_deg", "deg"
    double factor = 1;       ///< rad or m per one of it
  };
  std::vector<calibration::Measurement> readings;
  std::vector<JointColumn> joints;  ///< in the order of the arm's
  calibration::ReadingUnits units;
};

/// Returns readings with their columns' units, those past joint limits among them. Ways may also be taken from readings
/// that were read before.
[[nodiscard]] MeasurementTable parseMeasurementTable(const std::string& text, const std::string& file,
                                                     const deflection::Arm& arm,
                                                     const tubesheets::Sheet* sheet = nullptr,
                                                     const std::vector<calibration::Measurement>& before = {});

/// Throws InputError for the first joint reading past its limits, with the advice.
void requireWithinLimits(const MeasurementTable& table, const deflection::Arm& arm, const std::string& file,
                         const std::string& advice = "");

/// Whether a joint reading is past its limits, by more than its own noise.
[[nodiscard]] bool isPastLimits(const calibration::Measurement& reading, const deflection::Arm& arm);

/// The same from text; `file` is the name for messages.
[[nodiscard]] std::vector<calibration::Measurement> parseMeasurements(const std::string& text, const std::string& file,
                                                                      const deflection::Arm& arm,
                                                                      const tubesheets::Sheet* sheet = nullptr);

}  // namespace tubeplan::app
