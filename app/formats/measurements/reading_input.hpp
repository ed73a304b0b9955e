// What commands that fit readings of any kind ask of them beside what the file must have.
#pragma once

#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "app/storage/input_error.hpp"
#include "calibration/estimation/identification.hpp"
#include "calibration/measurement.hpp"
#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::app {

/// Gives every reading a sigma: its own, else `sigma` (in the cell's length unit; 0: not given), else for a touch that
/// of the cell's calibration tool. Throws InputError where none is known.
void stateSigma(std::vector<calibration::Measurement>& readings, const Cell& cell, const std::string& file,
                double sigma);

/// Throws InputError for the first reading at which a formula of the cell has no finite value or slope.
void requireDefinedFormulas(const std::vector<calibration::Measurement>& readings, const Cell& cell,
                            const std::string& file);

/// The readings of a measurement file as fits want them: each with a sigma (stateSigma), all formulas of the cell
/// defined (requireDefinedFormulas). Throws InputError.
[[nodiscard]] std::vector<calibration::Measurement> readReadings(const std::string& file, const Cell& cell,
                                                                 double sigma = 0);

/// A cell and the readings that its model is fitted to or judged by.
struct CellReadings {
  Cell cell;
  std::string file;  ///< of the readings, for messages
  std::vector<calibration::Measurement> readings;
  calibration::MeasurementChecks checks = {};  ///< what looks wrong with them
};

/// What a user may say of readings and of what is known beforehand, beside their files.
struct MeasurementOptions {
  double sigma = 0;                 ///< in the cell's length unit; 0: not given
  std::vector<std::string> priors;  ///< as takePriors() wants them
  std::vector<std::string> assume;  ///< as takeAssumptions() wants them
};

/// Readings, and what looks wrong with them.
struct ReadingsWithChecks {
  std::vector<calibration::Measurement> readings;
  calibration::MeasurementChecks checks;
};

/// Files of readings, one after another: "one.csv + two.csv".
using ReadingFiles = std::vector<std::string>;
[[nodiscard]] std::string nameOf(const ReadingFiles& files);

/// readReadings() of files taken together, with the mistakes looked for; those that `options.assume` names are mended
/// first, in the readings and, for a base that is not known after all, in the cell. Throws InputError.
[[nodiscard]] ReadingsWithChecks readAndCheck(const ReadingFiles& files, Cell& cell, const MeasurementOptions& options);

/// The same from text.
[[nodiscard]] ReadingsWithChecks parseAndCheck(const std::string& text, const std::string& file, Cell& cell,
                                               const MeasurementOptions& options);

/// Both from their files, the readings as by readReadings. Throws InputError.
[[nodiscard]] CellReadings readCellReadings(const std::string& cell, const ReadingFiles& measurements,
                                            const MeasurementOptions& options = {});

/// Readings from text; ways may also be taken from readings that were read before.
[[nodiscard]] std::vector<calibration::Measurement> parseReadings(
    const std::string& text, const std::string& file, const Cell& cell, double sigma = 0,
    const std::vector<calibration::Measurement>& before = {});

/// Readings that do not determine enough, as bad input of their file: with the line where one reading is to blame.
[[nodiscard]] InputError inputErrorOf(const calibration::ReadingProblem& problem,
                                      const std::vector<calibration::Measurement>& readings, const std::string& file);

/// Plain sentences about a fit that looks wrong though its readings do not.
[[nodiscard]] std::vector<std::string> fitWarnings(const calibration::Identification& result,
                                                   const std::vector<calibration::Measurement>& readings);

/// Readings that do not determine what is free, as bad input of their file.
[[nodiscard]] InputError refusalOf(const std::optional<calibration::ReadingProblem>& problem, const std::string& reason,
                                   const CellReadings& input);

}  // namespace tubeplan::app
