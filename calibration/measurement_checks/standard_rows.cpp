#include "calibration/measurement_checks/standard_rows.hpp"

#include <algorithm>

#include "deflection/row_conventions.hpp"
#include "deflection/row_numbers.hpp"

namespace tubeplan::calibration {

namespace {

constexpr double kFarOff = 0.02;       // of the reach: an error that no drawing's tolerances make
constexpr double kFallAsStandard = 5;  // of the error, at least, that the other convention explains

bool allByDh(const deflection::Arm& arm) {
  return std::ranges::all_of(arm.rows, [](const auto& row) { return deflection::dhOf(row) != nullptr; });
}

}  // namespace

std::optional<MeasurementCheck> standardRows(const MistakeTrials& trials) {
  const double error_as_is = trials.asIs().ok ? trials.asIs().error : std::numeric_limits<double>::infinity();
  PlacedArm start = trials.checked().start;
  if (!(error_as_is > kFarOff * trials.reach()) || !allByDh(start.arm) || deflection::isStandard(start.arm.rows))
    return std::nullopt;
  deflection::readAsStandard(start.arm.rows);
  if (!deflection::findProblems(start.arm).empty()) return std::nullopt;
  std::vector<Measurement> readings;
  for (const Measurement& reading : trials.pool().readings)
    if (trials.pool().counted.contains(reading.id)) readings.push_back(reading);
  RobustFitOptions options;
  options.free = {{"tool.tip"}, true, trials.checked().free.priors};
  options.stop = trials.options().stop;
  const RobustFit fit = fitRobustly(std::move(start), readings, options);
  if (!fit.ok || fit.error * kFallAsStandard > error_as_is || fit.error > kFarOff * trials.reach()) return std::nullopt;
  return MeasurementCheck{"convention",
                          CheckSeverity::kMistake,
                          "the arm's rows fit these readings as standard Denavit-Hartenberg numbers, not as the "
                          "modified ones: write `convention: standard` in the arm's file",
                          error_as_is,
                          fit.error,
                          "",
                          {}};
}

}  // namespace tubeplan::calibration
