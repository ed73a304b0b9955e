#include "calibration/measurement_checks/misread_rows.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "deflection/row_conventions.hpp"
#include "deflection/row_numbers.hpp"

namespace tubeplan::calibration {

namespace {

constexpr double kFarOff = 0.02;       // error that no tolerance of a drawing explains, relative to the reach
constexpr double kFallByRows = 5;      // smallest factor by which the corrected rows must reduce the error
constexpr double kLeastTwist = 0.017;  // twist [rad] below which its sign cannot be determined

using Rows = std::vector<deflection::Row<double>>;

bool allByDh(const Rows& rows) {
  return std::ranges::all_of(rows, [](const auto& row) { return deflection::dhOf(row) != nullptr; });
}

double errorAsIs(const MistakeTrials& trials) {
  return trials.asIs().ok ? trials.asIs().error : std::numeric_limits<double>::infinity();
}

/// Returns the error of the measurements if the arm had these rows, with base and tip free [m]; infinite if the
/// measurements cannot be fitted.
double errorBy(const MistakeTrials& trials, Rows rows) {
  PlacedArm start = trials.checked().start;
  start.arm.rows = std::move(rows);
  if (!deflection::findProblems(start.arm).empty()) return std::numeric_limits<double>::infinity();
  return trials.triedBy(std::move(start)).error;
}

std::optional<MeasurementCheck> mistakeOf(const MistakeTrials& trials, const char* name, double error,
                                          const std::string& sentence) {
  if (!(error * kFallByRows < errorAsIs(trials)) || error > kFarOff * trials.reach()) return std::nullopt;
  return MeasurementCheck{name, CheckSeverity::kMistake, sentence, errorAsIs(trials), error, "", {}};
}

bool isFarOff(const MistakeTrials& trials) { return errorAsIs(trials) > kFarOff * trials.reach(); }

}  // namespace

std::optional<MeasurementCheck> standardRows(const MistakeTrials& trials) {
  Rows rows = trials.checked().start.arm.rows;
  if (!isFarOff(trials) || !allByDh(rows) || deflection::isStandard(rows)) return std::nullopt;
  deflection::readAsStandard(rows);
  return mistakeOf(trials, "convention", errorBy(trials, std::move(rows)),
                   "the arm's rows fit these readings as standard Denavit-Hartenberg numbers, not as the modified "
                   "ones: write `convention: standard` in the arm's file");
}

std::optional<MeasurementCheck> negatedTwists(const MistakeTrials& trials) {
  const Rows& written = trials.checked().start.arm.rows;
  if (!isFarOff(trials)) return std::nullopt;
  double least = std::numeric_limits<double>::infinity();
  std::string name;
  const auto tryRows = [&](Rows rows, const std::string& of) {
    if (const double error = errorBy(trials, std::move(rows)); error < least) least = error, name = of;
  };
  Rows all = written;
  int twisted = 0;
  for (std::size_t k = 0; k < written.size(); ++k) {
    const auto* dh = deflection::dhOf(written[k]);
    if (!dh || std::abs(dh->alpha) < kLeastTwist) continue;
    ++twisted;
    deflection::dhOf(all[k])->alpha = -dh->alpha;
    Rows changed_rows = written;
    deflection::dhOf(changed_rows[k])->alpha = -dh->alpha;
    tryRows(std::move(changed_rows), deflection::nameInFile(written[k], "dh.alpha"));
  }
  if (twisted > 1) tryRows(std::move(all), "every alpha");
  if (name.empty()) return std::nullopt;
  return mistakeOf(trials, "twist", least,
                   name + " has the other sign in these readings: correct it in the arm's file");
}

}  // namespace tubeplan::calibration
