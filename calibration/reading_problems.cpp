#include "calibration/reading_problems.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "calibration/fit.hpp"
#include "calibration/reading_prediction.hpp"

namespace tubeplan::calibration {

namespace {

bool isOnePosture(const std::vector<Measurement>& readings) {
  return std::all_of(readings.begin(), readings.end(), [&](const Measurement& m) {
    return (m.q - readings.front().q).cwiseAbs().maxCoeff() < 1e-3 && m.load == readings.front().load;
  });
}

std::string pointTouchedOnce(const std::vector<Measurement>& readings) {
  std::map<std::string, std::vector<std::string>> touched;
  for (const auto& reading : readings)
    if (reading.kind == MeasurementKind::kTouch && !reading.p_W) touched[reading.point].push_back(reading.id);
  for (const auto& [point, ids] : touched)
    if (ids.size() == 1)
      return "point " + point + ", whose place is not given, was touched once (reading " + ids.front() +
             "): it tells nothing; touch it again or remove it";
  return "";
}

int numbersMeasured(const std::vector<Measurement>& readings) {
  std::map<std::string, int> points;
  int count = 0;
  for (const auto& reading : readings) {
    count += rowsOf(reading);
    if (reading.kind == MeasurementKind::kTouch && !reading.p_W) points[reading.point] = 1;
  }
  return count - 3 * static_cast<int>(points.size());
}

/// One usual slip: what it would be, and the readings as they would then be meant.
struct UnitSlip {
  const char* what;
  void (*mend)(Measurement&);
};

void scaleJoints(Measurement& m, double factor) { m.q *= factor; }
void scalePlace(Measurement& m, double factor) {
  if (m.p_W) *m.p_W *= factor;
}

constexpr double kDegree = std::numbers::pi / 180;
constexpr std::array<UnitSlip, 8> kSlips{{
    {"the joint readings look like radians under a column in degrees", [](Measurement& m) { scaleJoints(m, 1 / kDegree); }},
    {"the joint readings look like degrees under a column in radians", [](Measurement& m) { scaleJoints(m, kDegree); }},
    {"the coordinates look like inches under a column in millimetres", [](Measurement& m) { scalePlace(m, 25.4); }},
    {"the coordinates look like millimetres under a column in inches", [](Measurement& m) { scalePlace(m, 1 / 25.4); }},
    {"the coordinates look like metres under a column in millimetres", [](Measurement& m) { scalePlace(m, 1e3); }},
    {"the coordinates look like millimetres under a column in metres", [](Measurement& m) { scalePlace(m, 1e-3); }},
    {"the loads look a thousand times too large", [](Measurement& m) { m.load *= 1e-3; }},
    {"the loads look a thousand times too small", [](Measurement& m) { m.load *= 1e3; }},
}};

double fittedRms(PlacedArm placed, const std::vector<Measurement>& readings) {
  alignPlacings(placed, readings);
  const auto weights = weighReadings(placed, readings);
  if (!weights) return std::numeric_limits<double>::infinity();
  const auto residual = whitenedResidual(placed, {}, readings, *weights, {}, false);
  return residual.ok ? errorSize(readings, *weights, residual.error).rms : std::numeric_limits<double>::infinity();
}

}  // namespace

std::string findReadingProblem(const std::vector<Measurement>& readings, const std::vector<Unknown>& unknowns) {
  if (readings.empty()) return "there is no reading to fit";
  if (const std::string once = pointTouchedOnce(readings); !once.empty()) return once;
  if (isOnePosture(readings)) return "all readings are at one posture under one load: they tell one point and no more";
  const auto named = std::count_if(unknowns.begin(), unknowns.end(), [](const Unknown& u) { return !u.is_geometry; });
  if (numbersMeasured(readings) < named)
    return "the readings hold " + std::to_string(numbersMeasured(readings)) + " numbers, fewer than the " +
           std::to_string(named) + " that are free";
  return "";
}

std::vector<ReadingSuspicion> findUnitSlips(const PlacedArm& placed, const std::vector<Measurement>& readings) {
  constexpr double kFarBetter = 0.2;
  std::vector<ReadingSuspicion> found;
  const double as_is = fittedRms(placed, readings);
  for (const UnitSlip& slip : kSlips) {
    auto meant = readings;
    for (auto& reading : meant) slip.mend(reading);
    const double mended = fittedRms(placed, meant);
    if (mended < kFarBetter * as_is) found.push_back({slip.what, as_is, mended});
  }
  return found;
}

}  // namespace tubeplan::calibration
