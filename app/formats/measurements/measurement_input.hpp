// Input of commands that fit measurements of any kind, with checks beyond the file format.
#pragma once

#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "app/storage/input_error.hpp"
#include "calibration/estimation/identification.hpp"
#include "calibration/measurement.hpp"
#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::app {

/// Sets the sigma of every measurement that states none: to `sigma` (in the cell's length unit) if it is above zero,
/// otherwise, for a touch, to the sigma of the cell's calibration tool. Throws InputError if neither is known, and for
/// a visit without any step unless `takes_none`.
void stateSigma(std::vector<calibration::Measurement>& measurements, const Cell& cell, const std::string& file,
                double sigma, bool takes_none = false);

/// Throws InputError for the first measurement at which a formula of the cell has no finite value or derivative.
void requireDefinedFormulas(const std::vector<calibration::Measurement>& measurements, const Cell& cell,
                            const std::string& file);

/// Returns the measurements in a file for use in a fit: each has a sigma (stateSigma()), and all formulas of the cell
/// are defined (requireDefinedFormulas()). Throws InputError.
[[nodiscard]] std::vector<calibration::Measurement> readMeasurements(const std::string& file, const Cell& cell,
                                                                     double sigma = 0);

/// Cell and measurements, for a fit of the cell's model or an assessment of the model.
struct CellMeasurements {
  Cell cell;
  std::string file;  ///< name of the file of measurements, for messages
  std::vector<calibration::Measurement> measurements;
  calibration::MeasurementChecks checks = {};  ///< findings of the checks for mistakes in the measurements
};

/// Options that concern measurements and priors.
struct MeasurementOptions {
  /// Standard deviation of measurements that state none, in the cell's length unit; 0 if not given.
  double sigma = 0;
  std::vector<std::string> priors;  ///< priors in the syntax of takePriors()
  std::vector<std::string> assume;  ///< assumptions in the syntax of takeAssumptions()
  bool takes_no_steps = false;      ///< true if visits in which no step entered are accepted
};

/// Measurements with the findings of the checks for mistakes.
struct MeasurementsWithChecks {
  std::vector<calibration::Measurement> measurements;
  calibration::MeasurementChecks checks;
};

/// Files whose measurements are used together; nameOf() returns their names for messages: "one.csv + two.csv".
using MeasurementFiles = std::vector<std::string>;
[[nodiscard]] std::string nameOf(const MeasurementFiles& files);

/// Reads files as readMeasurements() does, combines their measurements and checks for mistakes. First corrects the
/// mistakes named in `options.assume`, both in the measurements and, for an unknown base pose, in the cell. Throws
/// InputError.
[[nodiscard]] MeasurementsWithChecks readAndCheck(const MeasurementFiles& files, Cell& cell,
                                                  const MeasurementOptions& options);

/// Parses and checks the text of a table as readAndCheck() does; messages name the text as `file`. Throws InputError.
[[nodiscard]] MeasurementsWithChecks parseAndCheck(const std::string& text, const std::string& file, Cell& cell,
                                                   const MeasurementOptions& options);

/// Reads a cell and its measurements from files, as readCell() and readAndCheck() do. Throws InputError.
[[nodiscard]] CellMeasurements readCellMeasurements(const std::string& cell, const MeasurementFiles& measurement_files,
                                                    const MeasurementOptions& options = {});

/// Parses measurements as readMeasurements() does; relative measurements may also refer to measurements in `before`.
/// Throws InputError.
[[nodiscard]] std::vector<calibration::Measurement> parseMeasurementText(
    const std::string& text, const std::string& file, const Cell& cell, double sigma = 0,
    const std::vector<calibration::Measurement>& before = {});

/// Returns the error for measurements that do not determine enough parameters; the message names the line if a single
/// measurement is the cause.
[[nodiscard]] InputError inputErrorOf(const calibration::MeasurementProblem& problem,
                                      const std::vector<calibration::Measurement>& measurements,
                                      const std::string& file);

/// Returns warnings about a fit, one sentence each: on set-ups without measurements, on an arm that a fit to touches
/// may have shrunk, and on held-out measurements that cannot be compared with anything.
[[nodiscard]] std::vector<std::string> fitWarnings(const calibration::Identification& result,
                                                   const std::vector<calibration::Measurement>& measurements);

/// Returns the error for measurements that do not determine the free parameters, or for a cell without free parameters.
[[nodiscard]] InputError refusalOf(const std::optional<calibration::MeasurementProblem>& problem,
                                   const std::string& reason, const CellMeasurements& input);

}  // namespace tubeplan::app
