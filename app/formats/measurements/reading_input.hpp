// Input of commands that fit readings of any kind, with checks beyond the file format.
#pragma once

#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "app/storage/input_error.hpp"
#include "calibration/estimation/identification.hpp"
#include "calibration/measurement.hpp"
#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::app {

/// Sets the sigma of every reading that states none: to `sigma` (in the cell's length unit) if it is above zero,
/// otherwise, for a touch, to the sigma of the cell's calibration tool. Throws InputError if neither is known.
void stateSigma(std::vector<calibration::Measurement>& readings, const Cell& cell, const std::string& file,
                double sigma);

/// Throws InputError for the first reading at which a formula of the cell has no finite value or derivative.
void requireDefinedFormulas(const std::vector<calibration::Measurement>& readings, const Cell& cell,
                            const std::string& file);

/// Returns the readings in a file for use in a fit: each has a sigma (stateSigma()), and all formulas of the cell are
/// defined (requireDefinedFormulas()). Throws InputError.
[[nodiscard]] std::vector<calibration::Measurement> readReadings(const std::string& file, const Cell& cell,
                                                                 double sigma = 0);

/// Cell and readings, for a fit of the cell's model or an assessment of the model.
struct CellReadings {
  Cell cell;
  std::string file;  ///< name of the file of readings, for messages
  std::vector<calibration::Measurement> readings;
  calibration::MeasurementChecks checks = {};  ///< findings of the checks for mistakes in the readings
};

/// Options that concern readings and priors.
struct MeasurementOptions {
  double sigma = 0;  ///< standard deviation of readings that state none, in the cell's length unit; 0: not given
  std::vector<std::string> priors;  ///< priors in the syntax of takePriors()
  std::vector<std::string> assume;  ///< assumptions in the syntax of takeAssumptions()
};

/// Readings with the findings of the checks for mistakes.
struct ReadingsWithChecks {
  std::vector<calibration::Measurement> readings;
  calibration::MeasurementChecks checks;
};

/// Files whose readings are used together; nameOf() returns their names for messages: "one.csv + two.csv".
using ReadingFiles = std::vector<std::string>;
[[nodiscard]] std::string nameOf(const ReadingFiles& files);

/// Reads files as readReadings() does, combines their readings and checks for mistakes. First corrects the mistakes
/// named in `options.assume`, both in the readings and, for an unknown base pose, in the cell. Throws InputError.
[[nodiscard]] ReadingsWithChecks readAndCheck(const ReadingFiles& files, Cell& cell, const MeasurementOptions& options);

/// Parses and checks the text of a table as readAndCheck() does; messages name the text as `file`. Throws InputError.
[[nodiscard]] ReadingsWithChecks parseAndCheck(const std::string& text, const std::string& file, Cell& cell,
                                               const MeasurementOptions& options);

/// Reads a cell and its readings from files, as readCell() and readAndCheck() do. Throws InputError.
[[nodiscard]] CellReadings readCellReadings(const std::string& cell, const ReadingFiles& measurements,
                                            const MeasurementOptions& options = {});

/// Parses readings as readReadings() does; relative readings may also refer to readings in `before`. Throws InputError.
[[nodiscard]] std::vector<calibration::Measurement> parseReadings(
    const std::string& text, const std::string& file, const Cell& cell, double sigma = 0,
    const std::vector<calibration::Measurement>& before = {});

/// Returns the error for readings that do not determine enough parameters; the message names the line if a single
/// reading is the cause.
[[nodiscard]] InputError inputErrorOf(const calibration::ReadingProblem& problem,
                                      const std::vector<calibration::Measurement>& readings, const std::string& file);

/// Returns warnings about a fit, one sentence each: on set-ups that no reading names, on a fitted arm that touches may
/// have made too small, and on held-out readings that have nothing to be compared with.
[[nodiscard]] std::vector<std::string> fitWarnings(const calibration::Identification& result,
                                                   const std::vector<calibration::Measurement>& readings);

/// Returns the error for readings that do not determine the free parameters, or for a cell without free parameters.
[[nodiscard]] InputError refusalOf(const std::optional<calibration::ReadingProblem>& problem, const std::string& reason,
                                   const CellReadings& input);

}  // namespace tubeplan::app
