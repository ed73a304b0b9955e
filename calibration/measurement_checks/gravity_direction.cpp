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

constexpr double kFallByGravity = 5;    // smallest factor by which another direction must reduce the error
constexpr double kAboveNoise = 5;       // smallest ratio of error to noise at which a search starts
constexpr double kSameDirection = 0.9;  // cosine above which two directions are treated as equal
// The search continues if the best of the first directions reduces the error by more than this factor.
constexpr double kPromisingFall = 1.3;
// Smallest ratio of the errors at the angle kAway from the best direction to the error in the best direction.
constexpr double kClear = 2;
// The nearest world axis is chosen if its error is smaller than this multiple of the best error.
constexpr double kNearAxis = 1.5;
// First and smallest step of the search, and angle from the best direction to those with which it is compared [rad].
constexpr double kFirstLean = 0.35, kLastLean = 0.004, kAway = 0.3;

struct TriedDirection {
  Vector3d gravity_W = Vector3d::Zero();
  double error = std::numeric_limits<double>::infinity();  // error with this direction [m]
  Trial trial = {};
};

TriedDirection triedAlong(const MistakeTrials& trials, const Vector3d& direction) {
  throwIfStopped(trials.options().stop);
  PlacedArm start = trials.checked().start;
  start.arm.gravity_W = direction.normalized();
  const Vector3d gravity_W = start.arm.gravity_W;
  Trial trial = trials.triedBy(std::move(start));
  return {gravity_W, trial.error, std::move(trial)};
}

bool isWritten(const MistakeTrials& trials, const Vector3d& gravity_W) {
  return gravity_W.dot(trials.checked().start.arm.gravity_W) > kSameDirection;
}

/// Returns the gravity direction with the smallest error among the world's axes and their diagonals, except those near
/// the stated direction.
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

/// Returns four directions at this angle [rad] from `gravity_W`, each tilted to a different side, with their fits.
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

/// Refines a direction: moves to a neighbouring direction if it fits better, and halves the step otherwise. Finally
/// chooses the nearest axis of the world if it fits about as well.
TriedDirection settled(const MistakeTrials& trials, TriedDirection best) {
  for (double step = kFirstLean; step > kLastLean;)
    if (const auto next = leastAround(trials, best, step); next.error < best.error)
      best = next;
    else
      step /= 2;
  Eigen::Index axis = 0;
  const double along = best.gravity_W.cwiseAbs().maxCoeff(&axis);
  Vector3d nearest_axis = Vector3d::Zero();
  nearest_axis[axis] = best.gravity_W[axis] < 0 ? -1 : 1;
  if (along < kSameDirection) return best;
  const auto by_axis = triedAlong(trials, nearest_axis);
  return by_axis.error < kNearAxis * best.error ? by_axis : best;
}

}  // namespace

std::optional<FoundMistake> wrongGravityDirection(const MistakeTrials& trials) {
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
      fmt::format("gravity points along {0:g}, {1:g}, {2:g} of the world in these readings, {3:.0f} deg from the "
                  "direction in the cell: write `gravity: [{0:g}, {1:g}, {2:g}]` in the cell's file",
                  gravity_W.x(), gravity_W.y(), gravity_W.z(), turn * 180 / std::numbers::pi),
      as_is.error,
      best.error,
      "",
      {}};
  return FoundMistake{std::move(check), std::move(best.trial)};
}

}  // namespace tubeplan::calibration
