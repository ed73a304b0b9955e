#include "calibration/measurement_checks/rounded_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "calibration/measurements/reading_prediction.hpp"

namespace tubeplan::calibration {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kDisplaySteps[] = {1, 0.5, 0.1, 0.05, 0.01};  // deg, that displays round to
constexpr double kNearStep = 0.02;                             // of a step: a number written with few digits
constexpr std::size_t kLeastReadings = 8;
constexpr double kShareOfError = 1. / 3;  // of the error that the rounding makes, at least, and the other way round

/// Turning joints whose encoder is finer than the step.
std::vector<int> jointsFinerThan(double step, const deflection::Arm& arm) {
  std::vector<int> joints;
  for (int j = 0; j < arm.jointCount(); ++j)
    if (arm.joint(j).type == deflection::JointType::kRevolute && arm.joint(j).encoder_sigma < step / std::sqrt(12))
      joints.push_back(j);
  return joints;
}

bool areMultiples(const std::vector<Measurement>& readings, const std::vector<int>& joints, double step) {
  return std::ranges::all_of(readings, [&](const Measurement& reading) {
    return std::ranges::all_of(joints, [&](int j) {
      const double steps = reading.q[j] / step;
      return std::abs(steps - std::round(steps)) < kNearStep;
    });
  });
}

/// Root mean square of what the rounding moves the tips by [m].
double motionOfRounding(double step, const std::vector<int>& joints, const MistakeTrials& trials) {
  const PlacedArm& placed = trials.asIs().placed;
  PredictionRequest request;
  request.by_joints = true;
  double squares = 0;
  int count = 0;
  for (const auto& reading : trials.checked().readings) {
    if (!statedPlace(reading)) continue;
    const auto& X_WB = placed.base_poses[static_cast<std::size_t>(basePoseOf(placed, reading))].X_WB;
    const auto predicted = predictReading(placed.arm, X_WB, reading, request);
    if (!predicted.ok) continue;
    for (const int j : joints) squares += predicted.by_joints.col(j).squaredNorm() * step * step / 12;
    ++count;
  }
  return std::sqrt(squares / std::max(1, count));
}

}  // namespace

std::optional<MeasurementCheck> roundedJoints(const MistakeTrials& trials) {
  const CheckedReadings& checked = trials.checked();
  const Trial& as_is = trials.asIs();
  constexpr double kMisfit = 2;  // of chi-square for each degree of freedom
  if (checked.readings.size() < kLeastReadings || !(as_is.chi2_per_freedom > kMisfit)) return std::nullopt;
  for (const double degrees : kDisplaySteps) {
    const double step = degrees * kDegree;
    const auto joints = jointsFinerThan(step, checked.start.arm);
    if (joints.empty() || !areMultiples(checked.readings, joints, step)) continue;
    const double motion = motionOfRounding(step, joints, trials);
    const bool is_as_large = motion > kShareOfError * as_is.open_error && as_is.open_error > kShareOfError * motion;
    if (motion < trials.noise({}) || !is_as_large) return std::nullopt;
    const auto& unit = checked.units.coordinates;
    return MeasurementCheck{
        "rounded-joints",
        CheckSeverity::kRemark,
        fmt::format("all joint readings are multiples of {} deg: if they were rounded to it, that alone moves the tip "
                    "by about {:.2g} {}; take them with all the digits that the controller has",
                    degrees, motion / unit.factor, unit.name),
        kNoFigure,
        kNoFigure,
        "",
        {}};
  }
  return std::nullopt;
}

}  // namespace tubeplan::calibration
