#include "calibration/measurement_checks/gravity_direction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace tubeplan::calibration {

namespace {

constexpr double kFallByGravity = 5;    // of the error, at least, that another direction explains
constexpr double kAboveNoise = 5;       // times, at least, that the error is above the noise
constexpr double kSameDirection = 0.9;  // cosine, from which a direction is the one that is written
constexpr double kClear = 2;            // times, at least, that the next best direction is worse

struct TriedDirection {
  Eigen::Vector3d gravity_W = Eigen::Vector3d::Zero();
  double error = std::numeric_limits<double>::infinity();  // m
};

double errorWith(const MistakeTrials& trials, const Eigen::Vector3d& gravity_W) {
  PlacedArm start = trials.checked().start;
  start.arm.gravity_W = gravity_W;
  return trials.errorBy(std::move(start));
}

}  // namespace

std::optional<MeasurementCheck> gravityElsewhere(const MistakeTrials& trials) {
  const Trial& as_is = trials.asIs();
  if (!as_is.ok || as_is.error < kAboveNoise * trials.noise({})) return std::nullopt;
  std::vector<TriedDirection> tried;
  for (int axis = 0; axis < 3; ++axis)
    for (const int sign : {-1, 1}) {
      Eigen::Vector3d gravity_W = Eigen::Vector3d::Zero();
      gravity_W[axis] = sign;
      if (gravity_W.dot(trials.checked().start.arm.gravity_W) > kSameDirection) continue;
      tried.push_back({gravity_W, errorWith(trials, gravity_W)});
    }
  std::ranges::sort(tried, {}, &TriedDirection::error);
  const TriedDirection& best = tried.front();
  if (!(best.error * kFallByGravity < as_is.error) || !(best.error * kClear < tried[1].error)) return std::nullopt;
  return MeasurementCheck{
      "gravity",
      CheckSeverity::kMistake,
      fmt::format("gravity points along {0}, {1}, {2} of the world in these readings, not as the cell says: write "
                  "`gravity: [{0}, {1}, {2}]` in the cell's file",
                  best.gravity_W.x(), best.gravity_W.y(), best.gravity_W.z()),
      as_is.error,
      best.error,
      "",
      {}};
}

}  // namespace tubeplan::calibration
