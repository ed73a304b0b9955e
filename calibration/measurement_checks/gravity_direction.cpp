#include "calibration/measurement_checks/gravity_direction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace tubeplan::calibration {

namespace {

using Eigen::Vector3d;

constexpr double kFallByGravity = 5;    // of the error, at least, that another direction explains
constexpr double kAboveNoise = 5;       // times, at least, that the error is above the noise
constexpr double kSameDirection = 0.9;  // cosine, from which a direction is the one that is written
constexpr double kPromisingFall = 1.3;  // fall of the error by the nearest of the directions tried first
constexpr double kClear = 2;            // times, at least, that the error is larger a fifth of a right angle away
constexpr double kNearAxis = 1.5;       // times the least error, at most, that an axis of the world leaves
constexpr double kFirstLean = 0.35, kLastLean = 0.004, kAway = 0.3;  // rad

struct TriedDirection {
  Vector3d gravity_W = Vector3d::Zero();
  double error = std::numeric_limits<double>::infinity();  // m
  Trial trial = {};
};

TriedDirection triedAlong(const MistakeTrials& trials, const Vector3d& direction) {
  goOn(trials.options().stop);
  PlacedArm start = trials.checked().start;
  start.arm.gravity_W = direction.normalized();
  const Vector3d gravity_W = start.arm.gravity_W;
  Trial trial = trials.triedBy(std::move(start));
  return {gravity_W, trial.error, std::move(trial)};
}

bool isWritten(const MistakeTrials& trials, const Vector3d& gravity_W) {
  return gravity_W.dot(trials.checked().start.arm.gravity_W) > kSameDirection;
}

/// The best of the directions along the axes of the world and between two or three of them.
TriedDirection bestOfFew(const MistakeTrials& trials) {
  TriedDirection best;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        const Vector3d direction(x, y, z);
        if (direction.isZero() || isWritten(trials, direction.normalized())) continue;
        if (const auto tried = triedAlong(trials, direction); tried.error < best.error) best = tried;
      }
  return best;
}

/// The directions that lie so far to four sides [rad].
std::vector<TriedDirection> around(const MistakeTrials& trials, const Vector3d& gravity_W, double angle) {
  const Vector3d across = gravity_W.unitOrthogonal(), other = gravity_W.cross(across);
  std::vector<TriedDirection> tried;
  for (const Vector3d& side : {across, other, Vector3d(-across), Vector3d(-other)})
    tried.push_back(triedAlong(trials, std::cos(angle) * gravity_W + std::sin(angle) * side));
  return tried;
}

TriedDirection leastAround(const MistakeTrials& trials, const TriedDirection& from, double angle) {
  return std::ranges::min(around(trials, from.gravity_W, angle), {}, &TriedDirection::error);
}

/// Goes on to a better side as long as there is one, by steps that are halved where there is none; then to the nearest
/// axis of the world where that is as good.
TriedDirection settled(const MistakeTrials& trials, TriedDirection best) {
  for (double step = kFirstLean; step > kLastLean;)
    if (const auto next = leastAround(trials, best, step); next.error < best.error)
      best = next;
    else
      step /= 2;
  Eigen::Index axis = 0;
  const double along = best.gravity_W.cwiseAbs().maxCoeff(&axis);
  Vector3d whole = Vector3d::Zero();
  whole[axis] = best.gravity_W[axis] < 0 ? -1 : 1;
  if (along < kSameDirection) return best;
  const auto by_axis = triedAlong(trials, whole);
  return by_axis.error < kNearAxis * best.error ? by_axis : best;
}

}  // namespace

std::optional<FoundMistake> gravityElsewhere(const MistakeTrials& trials) {
  const Trial& as_is = trials.asIs();
  if (!as_is.ok || as_is.error < kAboveNoise * trials.noise({})) return std::nullopt;
  auto best = bestOfFew(trials);
  if (!(best.error * kPromisingFall < as_is.error)) return std::nullopt;
  best = settled(trials, best);
  if (!(best.error * kFallByGravity < as_is.error) || isWritten(trials, best.gravity_W)) return std::nullopt;
  if (!(best.error * kClear < leastAround(trials, best, kAway).error)) return std::nullopt;
  const Vector3d gravity_W = ((best.gravity_W * 1e3).array().round() / 1e3 + 0.).matrix();
  const double turn = std::acos(std::clamp(best.gravity_W.dot(trials.checked().start.arm.gravity_W), -1., 1.));
  MeasurementCheck check{
      "gravity",
      CheckSeverity::kMistake,
      fmt::format("gravity points along {0:g}, {1:g}, {2:g} of the world in these readings, {3:.0f} deg from where the "
                  "cell says: write `gravity: [{0:g}, {1:g}, {2:g}]` in the cell's file",
                  gravity_W.x(), gravity_W.y(), gravity_W.z(), turn * 180 / std::numbers::pi),
      as_is.error,
      best.error,
      "",
      {}};
  return FoundMistake{std::move(check), std::move(best.trial)};
}

}  // namespace tubeplan::calibration
