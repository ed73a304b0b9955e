// Input of commands that fit readings of any kind, with checks beyond those of the file's format.
#pragma once

#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "app/storage/input_error.hpp"
#include "calibration/estimation/identification.hpp"
#include "calibration/measurement.hpp"
#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::app {

/// Sets the sigma of every reading without one: to `sigma` (in the cell's length unit; 0: not given), else for a touch
/// to that of the cell's calibration tool. Throws InputError if none is known.
void stateSigma(std::vector<calibration::Measurement>& readings, const Cell& cell, const std::string& file,
                double sigma);

/// Throws InputError for the first reading at which a formula of the cell has no finite value or slope.
void requireDefinedFormulas(const std::vector<calibration::Measurement>& readings, const Cell& cell,
                            const std::string& file);

/// Returns the readings of a measurement file for a fit: each with a sigma (stateSigma), and with all formulas of the
/// cell defined (requireDefinedFormulas). Throws InputError.
[[nodiscard]] std::vector<calibration::Measurement> readReadings(const std::string& file, const Cell& cell,
                                                                 double sigma = 0);

/// Cell with the readings to which its model is fitted, or by which it is judged.
struct CellReadings {
  Cell cell;
  std::string file;  ///< name of the readings' file in messages
  std::vector<calibration::Measurement> readings;
  calibration::MeasurementChecks checks = {};  ///< findings about readings that look wrong
};

/// Options about readings and prior knowledge, in addition to the files.
struct MeasurementOptions {
  double sigma = 0;                 ///< noise of readings, in the cell's length unit; 0: not given
  std::vector<std::string> priors;  ///< priors in the syntax of takePriors()
  std::vector<std::string> assume;  ///< assumptions in the syntax of takeAssumptions()
};

/// Readings with findings about those that look wrong.
struct ReadingsWithChecks {
  std::vector<calibration::Measurement> readings;
  calibration::MeasurementChecks checks;
};

/// Files of readings to be joined, with the name "one.csv + two.csv" in messages.
using ReadingFiles = std::vector<std::string>;
[[nodiscard]] std::string nameOf(const ReadingFiles& files);

/// Reads files as readReadings() does, joins them and checks for mistakes. First corrects the mistakes named in
/// `options.assume`: in the readings and, for a base that is not known, in the cell. Throws InputError.
[[nodiscard]] ReadingsWithChecks readAndCheck(const ReadingFiles& files, Cell& cell, const MeasurementOptions& options);

/// Reads and checks a text of readings as readAndCheck() does; `file` is its name in messages. Throws InputError.
[[nodiscard]] ReadingsWithChecks parseAndCheck(const std::string& text, const std::string& file, Cell& cell,
                                               const MeasurementOptions& options);

/// Reads a cell and its readings from their files, the readings by readAndCheck(). Throws InputError.
[[nodiscard]] CellReadings readCellReadings(const std::string& cell, const ReadingFiles& measurements,
                                            const MeasurementOptions& options = {});

/// Returns the readings of a text as readReadings() does; relative readings may also refer to those in `before`. Throws
/// InputError.
[[nodiscard]] std::vector<calibration::Measurement> parseReadings(
    const std::string& text, const std::string& file, const Cell& cell, double sigma = 0,
    const std::vector<calibration::Measurement>& before = {});

/// Returns the error for readings that do not determine enough, with the line if a single reading is the cause.
[[nodiscard]] InputError inputErrorOf(const calibration::ReadingProblem& problem,
                                      const std::vector<calibration::Measurement>& readings, const std::string& file);

/// Returns sentences about a fit that looks wrong although its readings do not.
[[nodiscard]] std::vector<std::string> fitWarnings(const calibration::Identification& result,
                                                   const std::vector<calibration::Measurement>& readings);

/// Returns the error for readings that do not determine the free parameters, or for a cell without any.
[[nodiscard]] InputError refusalOf(const std::optional<calibration::ReadingProblem>& problem, const std::string& reason,
                                   const CellReadings& input);

}  // namespace tubeplan::app
