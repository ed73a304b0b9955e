#include "calibration/reading_problems.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "calibration/fit.hpp"
#include "calibration/reading_prediction.hpp"

namespace tubeplan::calibration {

namespace {

bool isOnePosture(const std::vector<Measurement>& readings) {
  return std::all_of(readings.begin(), readings.end(), [&](const Measurement& m) {
    return (m.q - readings.front().q).cwiseAbs().maxCoeff() < 1e-3 && m.load == readings.front().load;
  });
}

/// The reading that touched a point of unknown place alone, or nothing.
std::optional<int> loneTouch(const std::vector<Measurement>& readings) {
  std::map<std::string, std::vector<int>> touched;
  for (std::size_t k = 0; k < readings.size(); ++k)
    if (readings[k].kind == MeasurementKind::kTouch && !readings[k].p_W)
      touched[readings[k].point].push_back(static_cast<int>(k));
  for (const auto& [point, by] : touched)
    if (by.size() == 1) return by.front();
  return std::nullopt;
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
  m.distance *= factor;
}

constexpr double kDegree = std::numbers::pi / 180;
constexpr std::array<UnitSlip, 8> kSlips{{
    {"the joint readings look like radians under a column in degrees",
     [](Measurement& m) { scaleJoints(m, 1 / kDegree); }},
    {"the joint readings look like degrees under a column in radians", [](Measurement& m) { scaleJoints(m, kDegree); }},
    {"the coordinates look like inches under a column in millimetres", [](Measurement& m) { scalePlace(m, 25.4); }},
    {"the coordinates look like millimetres under a column in inches", [](Measurement& m) { scalePlace(m, 1 / 25.4); }},
    {"the coordinates look like metres under a column in millimetres", [](Measurement& m) { scalePlace(m, 1e3); }},
    {"the coordinates look like millimetres under a column in metres", [](Measurement& m) { scalePlace(m, 1e-3); }},
    {"the loads look a thousand times too large", [](Measurement& m) { m.load *= 1e-3; }},
    {"the loads look a thousand times too small", [](Measurement& m) { m.load *= 1e3; }},
}};

/// How far what the readings say is spread out [m]: an error of a tenth of it is large, however small in metres.
double extentOf(const PlacedArm& placed, const std::vector<Measurement>& readings) {
  Eigen::Matrix3Xd places(3, static_cast<Eigen::Index>(readings.size()));
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const Measurement& m = readings[k];
    auto place = places.col(static_cast<Eigen::Index>(k));
    if (m.kind == MeasurementKind::kDistance)
      place = Eigen::Vector3d(m.distance, 0, 0);
    else if (m.p_W)
      place = *m.p_W;
    else
      place = predictReading(placed.arm, placed.placings[static_cast<std::size_t>(placingOf(placed, m))].X_WB, m).value;
  }
  return std::sqrt((places.colwise() - places.rowwise().mean()).squaredNorm() / static_cast<double>(readings.size()));
}

/// Of the model as it stands, the bases placed.
struct Misfit {
  double rms = std::numeric_limits<double>::infinity();       // m
  double relative = std::numeric_limits<double>::infinity();  // to the extent of what was read
};

Misfit misfitOf(PlacedArm placed, const std::vector<Measurement>& readings) {
  alignPlacings(placed, readings);
  const auto weights = weighReadings(placed, readings);
  if (!weights) return {};
  const auto residual = whitenedResidual(placed, {}, readings, *weights, {}, false);
  if (!residual.ok) return {};
  const double rms = errorSize(readings, *weights, residual.error).rms;
  return {rms, rms / extentOf(placed, readings)};
}

}  // namespace

std::optional<ReadingProblem> findReadingProblem(const std::vector<Measurement>& readings,
                                                 const std::vector<Unknown>& unknowns) {
  if (readings.empty())
    return ReadingProblem{-1, "no reading to fit", "readings that are not marked held-out", "mark some as fit"};
  if (const auto lone = loneTouch(readings)) {
    const Measurement& touch = readings[static_cast<std::size_t>(*lone)];
    return ReadingProblem{*lone, "the only touch of point " + touch.point + " (reading " + touch.id + ")",
                          "two touches or more of a point whose place is not given",
                          "touch it again, give its place, or remove the reading: it tells nothing"};
  }
  if (isOnePosture(readings))
    return ReadingProblem{-1, "all readings at one posture under one load", "several postures or loads",
                          "they tell one point and no more: measure elsewhere too"};
  const auto named = std::count_if(unknowns.begin(), unknowns.end(), [](const Unknown& u) { return !u.is_geometry; });
  const int measured = numbersMeasured(readings);
  if (measured < named)
    return ReadingProblem{-1, "readings that hold " + std::to_string(measured) + " numbers",
                          "as many as the " + std::to_string(named) + " that are free", "measure more or free fewer"};
  return std::nullopt;
}

std::vector<ReadingSuspicion> findUnitSlips(const PlacedArm& placed, const std::vector<Measurement>& readings) {
  constexpr double kFarBetter = 0.2;
  constexpr double kAsGood = 3;  // times the best: slips that mend no more than a part of it are not meant
  std::vector<std::pair<double, ReadingSuspicion>> far_better;  // by relative misfit
  const Misfit as_is = misfitOf(placed, readings);
  double best = std::numeric_limits<double>::infinity();
  for (const UnitSlip& slip : kSlips) {
    auto meant = readings;
    for (auto& reading : meant) slip.mend(reading);
    const Misfit mended = misfitOf(placed, meant);
    if (mended.rms >= kFarBetter * as_is.rms || mended.relative >= kFarBetter * as_is.relative) continue;
    far_better.push_back({mended.relative, {slip.what, as_is.rms, mended.rms}});
    best = std::min(best, mended.relative);
  }
  std::vector<ReadingSuspicion> found;
  for (const auto& [relative, suspicion] : far_better)
    if (relative <= kAsGood * best) found.push_back(suspicion);
  return found;
}

}  // namespace tubeplan::calibration
