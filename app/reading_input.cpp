#include "app/reading_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/input_error.hpp"
#include "app/readers/measurements_reader.hpp"
#include "app/readers/priors_reader.hpp"
#include "app/readers/text_file.hpp"
#include "app/touch_input.hpp"
#include "calibration/reading_prediction.hpp"
#include "calibration/reading_problems.hpp"
#include "deflection/effects/formula.hpp"

namespace tubeplan::app {

namespace {

using calibration::Identification, calibration::Measurement, calibration::MeasurementKind;

constexpr double kFarTooLarge = 3;  // times the noise floor from which readings are searched for slips

bool isFarOff(const Identification& result) {
  if (result.status == calibration::IdentificationStatus::kNotConverged) return true;
  return std::isfinite(result.after.rms) && result.after.rms > kFarTooLarge * result.noise_floor;
}

/// An outlier on a hole of the sheet whose tip lies nearer a neighbour.
std::string mistakenHole(const Identification& result, const calibration::Outlier& outlier, const Measurement& reading,
                         const Cell& cell) {
  const auto name = parseHoleName(reading.point);
  if (!cell.sheet || !name || !reading.p_W) return "";
  const auto own = cell.sheet->indexOf(name->row, name->column);
  if (!own || outlier.size < cell.sheet->pitch / 2) return "";
  const auto& X_WB = result.fitted.placings.at(static_cast<std::size_t>(placingOf(result.fitted, reading))).X_WB;
  const auto tip = calibration::predictReading(result.fitted.arm, X_WB, reading);
  if (!tip.ok) return "";
  const tubesheets::Tube* nearest = nullptr;
  double least = cell.sheet->pitch / 2;
  for (const auto& tube : cell.sheet->tubes) {
    const double distance = std::hypot(tube.x - tip.value[0], tube.y - tip.value[1]);
    if (distance < least) least = distance, nearest = &tube;
  }
  if (!nearest || (nearest->row == name->row && nearest->column == name->column)) return "";
  return fmt::format("reading {} named {} fits R{}C{}: was the hole mistaken?", reading.id, reading.point, nearest->row,
                     nearest->column);
}

std::string heavyLoad(const std::vector<Measurement>& readings, const deflection::Arm& arm, const Units& units) {
  double weight = 0, heaviest = 0;
  for (const auto& row : arm.rows) {
    weight += row.weight.end + row.weight.distributed * deflection::reachOf(arm);
    for (const auto& lump : row.weight.lumps) weight += lump.weight;
  }
  for (const auto& reading : readings) heaviest = std::max(heaviest, reading.load);
  if (weight == 0 || heaviest < 10 * weight) return "";
  return fmt::format("a load of {:.4g} {} hangs on an arm that weighs less than {:.4g} {}: is the load's unit right?",
                     heaviest / units.factor(dimension::kForce), units.force().name,
                     weight / units.factor(dimension::kForce), units.force().name);
}

/// Touches of points that nobody measured reward a smaller arm: nothing in them is a length.
std::string shrunkenArm(const Identification& result, const std::vector<Measurement>& readings) {
  constexpr double kTooGood = 0.5;  // of chi-square per degree of freedom
  constexpr int kMany = 30;         // degrees of freedom from which that is no chance
  const bool is_blind = std::all_of(readings.begin(), readings.end(), [](const Measurement& reading) {
    return reading.kind == MeasurementKind::kTouch && !reading.p_W;
  });
  if (!is_blind || result.degrees_of_freedom < kMany) return "";
  const double per_degree = result.chi2 / result.degrees_of_freedom;
  if (!(per_degree < kTooGood)) return "";
  return fmt::format(
      "what is left is far below the noise ({:.2g} of chi-square per degree of freedom): touches of points that nobody "
      "measured are fitted best by an arm that shrinks; hold its lengths or measure one, unless sigma is too large",
      per_degree);
}

/// Joint readings that are all as small as angles in radians are, and would be within the joints' limits if they were.
/// Touches of points that nobody measured fit either way, so no error tells.
std::string smallAngles(const std::vector<Measurement>& readings, const deflection::Arm& arm) {
  constexpr double kDegree = std::numbers::pi / 180, kTurn = 2 * std::numbers::pi;
  constexpr std::size_t kFew = 4;
  if (readings.size() < kFew) return "";
  const auto active = deflection::activeRows(arm);
  double largest = 0;
  for (std::size_t j = 0; j < active.size(); ++j) {
    const auto& joint = arm.rows[static_cast<std::size_t>(active[j])].joint;
    if (joint.type != deflection::JointType::kRevolute) continue;
    for (const auto& reading : readings) {
      const double file_number = reading.q[static_cast<Eigen::Index>(j)] / kDegree;
      if (std::abs(file_number) > kTurn || file_number < joint.lower || file_number > joint.upper) return "";
      largest = std::max(largest, std::abs(file_number));
    }
  }
  if (largest == 0) return "";
  return fmt::format("no joint reading is larger than {:.3g} deg: are they radians?", largest);
}

}  // namespace

void stateSigma(std::vector<Measurement>& readings, const Cell& cell, const std::string& file, double sigma) {
  if (!std::isfinite(sigma) || sigma < 0)
    throw InputError("--sigma", fmt::format("{}", sigma),
                     "a noise above zero, in " + std::string(cell.units.length().name));
  for (auto& reading : readings) {
    if (std::isfinite(reading.sigma)) continue;
    if (sigma > 0)
      reading.sigma = cell.units.toInternal(sigma, dimension::kLength);
    else if (reading.kind == MeasurementKind::kTouch && cell.tool)
      reading.sigma = touchSigmaOf(*cell.tool);
    else
      throw InputError(fmt::format("{}:{}", file, reading.line), "a reading without sigma", "its noise",
                       fmt::format("add a column sigma_{} or --sigma", cell.units.length().name));
  }
}

void requireDefinedFormulas(const std::vector<Measurement>& readings, const Cell& cell, const std::string& file) {
  for (const auto& reading : readings) {
    const auto posture = calibration::postureOf(reading, cell.arm, cell.X_WB);
    const auto undefined = deflection::findUndefinedFormula(cell.arm, posture);
    if (!undefined.empty())
      throw InputError(fmt::format("{}:{} (reading {})", file, reading.line, reading.id), undefined,
                       "a formula with a finite value at every reading", "change the formula in " + cell.path);
  }
}

namespace {

std::vector<Measurement> asFitsWant(std::vector<Measurement> readings, const std::string& file, const Cell& cell,
                                    double sigma) {
  stateSigma(readings, cell, file, sigma);
  requireDefinedFormulas(readings, cell, file);
  return readings;
}

}  // namespace

std::vector<Measurement> readReadings(const std::string& file, const Cell& cell, double sigma) {
  return asFitsWant(readMeasurements(file, cell.arm, cell.sheet ? &*cell.sheet : nullptr), file, cell, sigma);
}

CellReadings readCellReadings(const std::string& cell, const std::string& measurements,
                              const MeasurementOptions& options) {
  CellReadings read{readCell(cell), measurements, {}};
  takePriors(options.priors, read.cell);
  read.readings = readReadings(measurements, read.cell, options.sigma);
  return read;
}

std::vector<Measurement> parseReadings(const std::string& text, const std::string& file, const Cell& cell,
                                       double sigma) {
  checkText(file, text);
  return asFitsWant(parseMeasurements(text, file, cell.arm, cell.sheet ? &*cell.sheet : nullptr), file, cell, sigma);
}

namespace {

/// Those made at the placings that were fitted: a stage has only its own.
std::vector<Measurement> readingsAt(const calibration::PlacedArm& placed, const std::vector<Measurement>& readings) {
  std::vector<Measurement> here;
  for (const auto& reading : readings)
    if (std::any_of(placed.placings.begin(), placed.placings.end(),
                    [&](const auto& placing) { return placing.setup == reading.setup; }))
      here.push_back(reading);
  return here;
}

}  // namespace

InputError inputErrorOf(const calibration::ReadingProblem& problem, const std::vector<Measurement>& readings,
                        const std::string& file) {
  const std::string where =
      problem.reading < 0 ? file
                          : fmt::format("{}:{}", file, readings.at(static_cast<std::size_t>(problem.reading)).line);
  return InputError(where, problem.found, problem.expected, problem.advice);
}

std::vector<std::string> readingWarnings(const Identification& result, const std::vector<Measurement>& readings,
                                         const Cell& cell) {
  std::vector<std::string> warnings;
  if (const auto heavy = heavyLoad(readings, cell.arm, cell.units); !heavy.empty()) warnings.push_back(heavy);
  if (const auto small = smallAngles(readings, cell.arm); !small.empty()) warnings.push_back(small);
  if (const auto shrunken = shrunkenArm(result, readings); !shrunken.empty()) warnings.push_back(shrunken);
  if (isFarOff(result))
    for (const auto& slip : calibration::findUnitSlips(result.start, readingsAt(result.start, readings)))
      warnings.push_back(fmt::format("{}: so read, the error falls from {:.4g} to {:.4g} {}", slip.what,
                                     slip.rms_as_is / cell.units.factor(dimension::kLength),
                                     slip.rms_if / cell.units.factor(dimension::kLength), cell.units.length().name));
  for (const auto& outlier : result.outliers) {
    const auto& reading = readings.at(static_cast<std::size_t>(outlier.reading));
    if (const auto mistaken = mistakenHole(result, outlier, reading, cell); !mistaken.empty())
      warnings.push_back(mistaken);
  }
  return warnings;
}

}  // namespace tubeplan::app
