#include "calibration/measurements/reading_problems.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/reading_prediction.hpp"

namespace tubeplan::calibration {

namespace {

bool isOnePosture(const std::vector<Measurement>& readings) {
  return std::all_of(readings.begin(), readings.end(), [&](const Measurement& m) {
    return (m.q - readings.front().q).cwiseAbs().maxCoeff() < 1e-3 && m.load == readings.front().load;
  });
}

/// Returns the first reading of an unknown place that too few share, or nothing.
std::optional<int> loneReading(const std::vector<Measurement>& readings) {
  std::map<std::string, std::vector<int>> touched;
  for (std::size_t k = 0; k < readings.size(); ++k)
    if (hasUnknownPlace(readings[k])) touched[placeOf(readings[k])].push_back(static_cast<int>(k));
  for (const auto& [place, by] : touched)
    if (static_cast<int>(by.size()) < leastOfPlace(readings[static_cast<std::size_t>(by.front())])) return by.front();
  return std::nullopt;
}

/// Returns the problem of a touched surface with too few readings: as many as its numbers only place it.
ReadingProblem fewOfSurface(int place, const std::vector<Measurement>& readings) {
  const Measurement& first = readings[static_cast<std::size_t>(place)];
  const auto count = std::count_if(readings.begin(), readings.end(),
                                   [&](const Measurement& m) { return placeOf(m) == placeOf(first); });
  return {place, std::to_string(count) + " readings of the " + placeOf(first) + " (" + first.id + " the first)",
          std::to_string(leastOfPlace(first)) + " or more of one " + kindOf(first).name,
          "touch it again elsewhere, or remove them: so few only say where it is"};
}

}  // namespace

int numbersMeasured(const std::vector<Measurement>& readings) {
  std::map<std::string, int> places;
  int count = 0;
  for (const auto& reading : readings) {
    count += rowsOf(reading);
    if (hasUnknownPlace(reading)) places[placeOf(reading)] = placeNumbers(reading);
  }
  for (const auto& [place, numbers] : places) count -= numbers;
  return count;
}

std::optional<ReadingProblem> findReadingProblem(const std::vector<Measurement>& readings,
                                                 const std::vector<Unknown>& unknowns) {
  if (readings.empty())
    return ReadingProblem{-1, "no reading to fit", "readings that are not marked held-out", "mark some as fit"};
  if (const auto lone = loneReading(readings)) {
    if (touchesSurface(readings[static_cast<std::size_t>(*lone)])) return fewOfSurface(*lone, readings);
    const Measurement& touch = readings[static_cast<std::size_t>(*lone)];
    return ReadingProblem{*lone, "the only touch of point " + touch.point + " (reading " + touch.id + ")",
                          "two or more touches of a point of unknown position",
                          "touch it again, give its position, or remove the reading: it carries no information"};
  }
  if (isOnePosture(readings))
    return ReadingProblem{-1, "all readings at one posture under one load", "several postures or loads",
                          "they determine a single point: measure elsewhere too"};
  const auto named = std::count_if(unknowns.begin(), unknowns.end(), [](const Unknown& u) { return !u.is_geometry; });
  const int measured = numbersMeasured(readings);
  if (measured < named)
    return ReadingProblem{-1, "readings that hold " + std::to_string(measured) + " numbers",
                          "as many as the " + std::to_string(named) + " that are free", "measure more or free fewer"};
  return std::nullopt;
}

}  // namespace tubeplan::calibration
