#include "calibration/measurements/measurement_problems.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/measurement_prediction.hpp"

namespace tubeplan::calibration {

namespace {

bool isOnePosture(const std::vector<Measurement>& measurements) {
  return std::all_of(measurements.begin(), measurements.end(), [&](const Measurement& m) {
    return (m.q - measurements.front().q).cwiseAbs().maxCoeff() < 1e-3 && m.load == measurements.front().load;
  });
}

/// Returns the index of the first measurement of an unknown place that has too few measurements; empty if there is
/// none.
std::optional<int> underdeterminedMeasurement(const std::vector<Measurement>& measurements) {
  std::map<std::string, std::vector<int>> touched;
  for (std::size_t k = 0; k < measurements.size(); ++k)
    if (hasUnknownPlace(measurements[k])) touched[placeOf(measurements[k])].push_back(static_cast<int>(k));
  for (const auto& [place, by] : touched)
    if (static_cast<int>(by.size()) < leastOfPlace(measurements[static_cast<std::size_t>(by.front())]))
      return by.front();
  return std::nullopt;
}

/// Reports that a surface was touched too few times. Without more measurements than parameters, it gives no information
/// on the arm.
MeasurementProblem fewOfSurface(int place, const std::vector<Measurement>& measurements) {
  const Measurement& first = measurements[static_cast<std::size_t>(place)];
  const auto count = std::count_if(measurements.begin(), measurements.end(),
                                   [&](const Measurement& m) { return placeOf(m) == placeOf(first); });
  return {place,
          "the " + placeOf(first) + " has " + std::to_string(count) + " readings (the first is " + first.id +
              "), but a " + kindOf(first).name + " needs at least " + std::to_string(leastOfPlace(first)),
          "touch it again elsewhere, or remove its readings: so few readings determine only its place"};
}

}  // namespace

int numbersMeasured(const std::vector<Measurement>& measurements) {
  std::map<std::string, int> places;
  int count = 0;
  for (const auto& measurement : measurements) {
    count += rowsOf(measurement);
    if (hasUnknownPlace(measurement)) places[placeOf(measurement)] = placeNumbers(measurement);
  }
  for (const auto& [place, numbers] : places) count -= numbers;
  return count;
}

std::optional<MeasurementProblem> findMeasurementProblem(const std::vector<Measurement>& measurements,
                                                         const std::vector<Unknown>& unknowns) {
  if (measurements.empty())
    return MeasurementProblem{-1, "there is no reading to fit", "mark some readings as fit, not held-out"};
  if (const auto underdetermined = underdeterminedMeasurement(measurements)) {
    if (touchesSurface(measurements[static_cast<std::size_t>(*underdetermined)]))
      return fewOfSurface(*underdetermined, measurements);
    const Measurement& touch = measurements[static_cast<std::size_t>(*underdetermined)];
    return MeasurementProblem{*underdetermined,
                              "point " + touch.point + ", whose position is unknown, is touched only once (reading " +
                                  touch.id + "), which carries no information",
                              "touch the point again, give its position, or remove the reading"};
  }
  if (isOnePosture(measurements))
    return MeasurementProblem{-1, "all readings are at one posture under one load, so they determine a single point",
                              "measure at several postures, or under several loads"};
  const auto named = std::count_if(unknowns.begin(), unknowns.end(), [](const Unknown& u) { return !u.is_geometry; });
  const int measured = numbersMeasured(measurements);
  if (measured < named)
    return MeasurementProblem{-1,
                              "the readings hold " + std::to_string(measured) + " numbers, fewer than the " +
                                  std::to_string(named) + " free numbers",
                              "add readings, or free fewer numbers"};
  return std::nullopt;
}

}  // namespace tubeplan::calibration
