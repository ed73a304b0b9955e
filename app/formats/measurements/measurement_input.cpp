#include "app/formats/measurements/measurement_input.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/formats/cell/priors_reader.hpp"
#include "app/formats/measurements/assumptions.hpp"
#include "app/formats/measurements/measurements_reader.hpp"
#include "app/formats/other_file.hpp"
#include "app/formats/sheet/touch_input.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"
#include "app/storage/text_file.hpp"
#include "app/studies/measurements/touched_holes.hpp"
#include "app/studies/model/cell_fit.hpp"
#include "calibration/measurement_checks/copies.hpp"
#include "calibration/measurement_checks/joint_limits.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/measurement_posture.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/measurements/measurement_problems.hpp"
#include "deflection/effects/formula.hpp"

namespace tubeplan::app {

namespace {

using calibration::Identification, calibration::Measurement;

/// Returns warnings about set-ups of the cell to which no measurement refers. A mistyped name in the measurements would
/// silently make the rows flexible that are rigid in the set-up.
std::vector<std::string> unnamedSetups(const deflection::Arm& arm, const std::vector<Measurement>& measurements) {
  std::vector<std::string> named, warnings;
  for (const auto& measurement : measurements)
    if (std::find(named.begin(), named.end(), measurement.setup) == named.end()) named.push_back(measurement.setup);
  for (const auto& mounting : arm.mountings) {
    if (std::find(named.begin(), named.end(), mounting.setup) != named.end()) continue;
    const std::string near = suggestion(mounting.setup, named);
    warnings.push_back("no reading is of the set-up " + inQuotes(mounting.setup) +
                       ", whose rows the cell has as rigid" + (near.empty() ? "" : "; " + near));
  }
  return warnings;
}

/// Returns a warning if a fit may have shrunk the arm; otherwise empty. Touches of points at unknown positions do not
/// determine any length, except through a ball's radius, and a smaller arm fits them better.
std::string shrunkenArm(const Identification& result, const std::vector<Measurement>& measurements) {
  constexpr double kTooGood = 0.5;  // chi-square per degree of freedom below which a fit is suspicious
  constexpr int kMany = 30;         // degrees of freedom above which such a small chi-square cannot be due to chance
  const bool is_blind = std::all_of(measurements.begin(), measurements.end(), [](const Measurement& measurement) {
    return hasUnknownPlace(measurement) && std::isnan(measurement.kind_values[0]);
  });
  if (!is_blind || result.degrees_of_freedom < kMany) return "";
  const double per_degree = result.chi2 / result.degrees_of_freedom;
  if (!(per_degree < kTooGood)) return "";
  return fmt::format(
      "the residuals are far below the noise (chi-square per degree of freedom {:.2g}): touches of points of unknown "
      "position are fitted best by an arm that shrinks; keep its lengths fixed or measure one, unless sigma is too "
      "large",
      per_degree);
}

void settleCounts(std::vector<Measurement>& measurements, const Cell& cell, const std::string& file, bool takes_none) {
  const auto counts = [](const Measurement& measurement) { return kindOf(measurement).counts_steps; };
  const auto first = std::find_if(measurements.begin(), measurements.end(), counts);
  if (first == measurements.end()) return;
  if (!cell.tool)
    throw InputError::problem(fmt::format("{}:{}", file, first->line),
                              "the reading counts steps, but the cell has no calibration tool",
                              "add `calibration_tool` with its steps and tolerances to " + cell.path);
  settleSteps(measurements, cell, file, takes_none);
}

/// Sets the sigma of a measurement that measures only angles to the noise of the angles times a lever. Throws
/// InputError for a measurement of angles without turn_sigma.
void stateTurnSigma(Measurement& measurement, const std::string& file, const Cell& cell) {
  const auto& kind = kindOf(measurement);
  if (kind.turn_rows == 0) return;
  if (!std::isfinite(measurement.turn_sigma))
    throw InputError::problem(
        fmt::format("{}:{}", file, measurement.line),
        fmt::format("the reading of kind {} has no turn_sigma, which states the noise of its angles", kind.name),
        fmt::format("add a column turn_sigma_{}", cell.units.angle().name));
  if (kind.rows <= kind.turn_rows) measurement.sigma = calibration::kTurnLever * measurement.turn_sigma;
}

}  // namespace

void stateSigma(std::vector<Measurement>& measurements, const Cell& cell, const std::string& file, double sigma,
                bool takes_none) {
  if (!std::isfinite(sigma) || sigma < 0)
    throw InputError("--sigma", fmt::format("{}", sigma),
                     "a noise of zero or more, in " + std::string(cell.units.length().name));
  settleCounts(measurements, cell, file, takes_none);
  for (auto& measurement : measurements) {
    stateTurnSigma(measurement, file, cell);
    if (std::isfinite(measurement.sigma)) continue;
    if (sigma > 0)
      measurement.sigma = cell.units.toInternal(sigma, dimension::kLength);
    else if (isTouch(measurement) && cell.tool)
      measurement.sigma = touchSigmaOf(*cell.tool);
    else
      throw InputError::problem(fmt::format("{}:{}", file, measurement.line),
                                "the reading has no sigma, which states its noise",
                                fmt::format("add a column sigma_{} or --sigma", cell.units.length().name));
  }
}

void requireDefinedFormulas(const std::vector<Measurement>& measurements, const Cell& cell, const std::string& file) {
  for (const auto& measurement : measurements) {
    const auto posture = calibration::postureOf(measurement, cell.arm, cell.X_WB);
    const auto undefined = deflection::findUndefinedFormula(cell.arm, posture);
    if (!undefined.empty())
      throw InputError::problem(
          fmt::format("{}:{} (reading {})", file, measurement.line, measurement.id), "the formula " + undefined,
          "change the formula in " + cell.path + ", so that its value is finite at every reading");
  }
}

std::vector<Measurement> readMeasurements(const std::string& file, const Cell& cell, double sigma) {
  return parseMeasurementText(readTextFile(file), file, cell, sigma);
}

CellMeasurements readCellMeasurements(const std::string& cell, const MeasurementFiles& measurement_files,
                                      const MeasurementOptions& options) {
  CellMeasurements read{readCell(cell), nameOf(measurement_files), {}};
  takePriors(options.priors, read.cell);
  auto [measurements, checks] = readAndCheck(measurement_files, read.cell, options);
  read.measurements = std::move(measurements);
  read.checks = std::move(checks);
  return read;
}

namespace {

/// Sets the units of quantities that have no column to the units of the cell.
void nameUnits(const Cell& cell, calibration::MeasurementUnits& units) {
  const auto name = [](const Unit& unit, calibration::NamedUnit& named) {
    if (named.name.empty()) named = {std::string(unit.name), unit.factor};
  };
  name(cell.units.length(), units.coordinates);
  name(cell.units.length(), units.sigma);
  name(cell.units.force(), units.loads);
}

calibration::CheckedMeasurements asChecked(const MeasurementTable& table, const Cell& cell) {
  return {startOf(cell, table.measurements), table.measurements, freeNumbersOf(cell), table.units,
          cell.sheet ? &*cell.sheet : nullptr};
}

bool isAnyPastLimits(const MeasurementTable& table, const Cell& cell) {
  return std::ranges::any_of(table.measurements,
                             [&](const Measurement& measurement) { return isPastLimits(measurement, cell.arm); });
}

/// Advice on joint readings beyond their limits: a mistake that would explain them; empty if there is none.
struct LimitAdvice {
  std::string text;
  bool brings_back = false;  ///< true if all measurements are within limits after the mistake is corrected
};
LimitAdvice adviceOnLimits(const MeasurementTable& table, const Cell& cell) {
  const auto checks = calibration::checkMeasurements(asChecked(table, cell));
  const auto* mistake = calibration::firstMistake(checks);
  if (!mistake || mistake->assume.empty()) return {};
  MeasurementTable corrected = table;
  Cell of_corrected = cell;
  (void)takeAssumptions({mistake->assume}, corrected, of_corrected);
  return {fmt::format("{}? try --assume {}", mistake->sentence, mistake->assume),
          !isAnyPastLimits(corrected, of_corrected)};
}

/// Shifts joint readings by a whole turn to bring them within their limits. Throws InputError, with advice, if
/// measurements remain beyond their limits, or if the correction of a mistake would bring all measurements within
/// limits.
std::optional<calibration::MeasurementCheck> settleLimits(MeasurementTable& table, const std::string& file,
                                                          const Cell& cell) {
  if (!isAnyPastLimits(table, cell)) return std::nullopt;
  const auto advice = adviceOnLimits(table, cell);
  if (advice.brings_back) requireWithinLimits(table, cell.arm, file, advice.text);
  auto checked = asChecked(table, cell);
  auto unwound = calibration::unwindJoints(checked);
  table.measurements = std::move(checked.measurements);
  requireWithinLimits(table, cell.arm, file, advice.text);
  return unwound;
}

MeasurementTable tableOf(const std::string& text, const std::string& file, const Cell& cell,
                         const MeasurementOptions& options, const std::vector<Measurement>& before = {}) {
  requireTable(file, text);
  checkText(file, text);
  MeasurementTable table = parseMeasurementTable(text, file, cell.arm, cell.sheet ? &*cell.sheet : nullptr, before);
  nameUnits(cell, table.units);
  stateSigma(table.measurements, cell, file, options.sigma, options.takes_no_steps);
  return table;
}

/// Returns one table with the measurements of all files. Throws InputError for an id that occurs twice.
MeasurementTable tableOfAll(const MeasurementFiles& files, const Cell& cell, const MeasurementOptions& options) {
  MeasurementTable all;
  std::set<std::string> ids;
  for (const auto& file : files) {
    MeasurementTable table = tableOf(readTextFile(file), file, cell, options, all.measurements);
    for (const auto& measurement : table.measurements)
      if (!ids.insert(measurement.id).second)
        throw InputError::problem(fmt::format("{}:{} (id)", file, measurement.line),
                                  "an earlier reading already has the id " + inQuotes(measurement.id),
                                  "give each reading an id of its own across all files");
    if (!all.measurements.empty())
      table.measurements.insert(table.measurements.begin(), all.measurements.begin(), all.measurements.end());
    all = std::move(table);
  }
  return all;
}

MeasurementsWithChecks checkTable(MeasurementTable table, const std::string& file, Cell& cell,
                                  const MeasurementOptions& options) {
  const bool is_overruled = takeAssumptions(options.assume, table, cell);
  if (!options.assume.empty()) settleCounts(table.measurements, cell, file, options.takes_no_steps);
  const auto unwound = settleLimits(table, file, cell);
  requireDefinedFormulas(table.measurements, cell, file);
  auto checked = asChecked(table, cell);
  const auto copies = is_overruled ? std::nullopt : calibration::takeCopiesOut(checked);
  auto checks = calibration::checkMeasurements(checked);
  if (is_overruled)
    for (auto& check : checks.checks) check.severity = calibration::CheckSeverity::kRemark;
  for (const auto& done : {unwound, copies})
    if (done) checks.checks.push_back(*done);
  checks.is_overruled = is_overruled;
  return {std::move(checked.measurements), std::move(checks)};
}

}  // namespace

MeasurementsWithChecks parseAndCheck(const std::string& text, const std::string& file, Cell& cell,
                                     const MeasurementOptions& options) {
  return checkTable(tableOf(text, file, cell, options), file, cell, options);
}

std::string nameOf(const MeasurementFiles& files) { return fmt::format("{}", fmt::join(files, " + ")); }

MeasurementsWithChecks readAndCheck(const MeasurementFiles& files, Cell& cell, const MeasurementOptions& options) {
  if (files.empty()) throw InputError("measurements", "no file", "one or more files of measurements");
  return checkTable(tableOfAll(files, cell, options), nameOf(files), cell, options);
}

std::vector<Measurement> parseMeasurementText(const std::string& text, const std::string& file, const Cell& cell,
                                              double sigma, const std::vector<Measurement>& before) {
  requireTable(file, text);
  checkText(file, text);
  auto table = parseMeasurementTable(text, file, cell.arm, cell.sheet ? &*cell.sheet : nullptr, before);
  requireWithinLimits(table, cell.arm, file);
  stateSigma(table.measurements, cell, file, sigma);
  requireDefinedFormulas(table.measurements, cell, file);
  return std::move(table.measurements);
}

InputError inputErrorOf(const calibration::MeasurementProblem& problem, const std::vector<Measurement>& measurements,
                        const std::string& file) {
  const std::string where =
      problem.measurement < 0
          ? file
          : fmt::format("{}:{}", file, measurements.at(static_cast<std::size_t>(problem.measurement)).line);
  return InputError::problem(where, problem.what, problem.advice);
}

std::vector<std::string> fitWarnings(const Identification& result, const std::vector<Measurement>& measurements) {
  std::vector<std::string> warnings = unnamedSetups(result.fitted.arm, measurements);
  if (auto shrunken = shrunkenArm(result, measurements); !shrunken.empty()) warnings.push_back(std::move(shrunken));
  if (result.not_judged > 0)
    warnings.push_back(
        fmt::format("{} held-out reading{} not judged: a single touch of an unmeasured point, or a set-up without a "
                    "fitted reading, cannot be compared with anything",
                    result.not_judged, result.not_judged == 1 ? " is" : "s are"));
  return warnings;
}

InputError refusalOf(const std::optional<calibration::MeasurementProblem>& problem, const std::string& reason,
                     const CellMeasurements& input) {
  if (problem) return inputErrorOf(*problem, input.measurements, input.file);
  if (input.cell.base_known && freeNumbersOf(input.cell).names.empty())
    return InputError::problem(input.cell.path, "there is no free parameter",
                               "write base: {known: false} to find the base, or add a list `identify`");
  return InputError::problem(input.file, reason, "check that the readings determine the free parameters");
}

}  // namespace tubeplan::app
