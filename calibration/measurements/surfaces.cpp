#include "calibration/measurements/surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "calibration/measurements/measurement_prediction.hpp"

namespace tubeplan::calibration {

namespace {

constexpr deflection::FlexibleKinematicsOptions kSettleExactly{1e-13, 100};

/// Returns the indices of the measurements of each surface, keyed by the surface's name.
std::map<std::string, std::vector<std::size_t>> bySurface(const std::vector<Measurement>& measurements) {
  std::map<std::string, std::vector<std::size_t>> groups;
  for (std::size_t k = 0; k < measurements.size(); ++k)
    if (touchesSurface(measurements[k])) groups[placeOf(measurements[k])].push_back(k);
  return groups;
}

/// Returns the tool's pose in the world frame, with the point of contact as its position [m]; empty if the shape does
/// not converge.
std::optional<ToolPose> contactOf(const PlacedArm& placed, const Measurement& measurement) {
  const auto tool = toolAt(placed, measurement, kSettleExactly);
  return tool ? std::optional(atMeasuredPoint(measurement, *tool)) : std::nullopt;
}

}  // namespace

bool touchSurfaces(const std::vector<Measurement>& measurements) {
  return std::any_of(measurements.begin(), measurements.end(), [](const Measurement& m) { return touchesSurface(m); });
}

bool settleSurfaces(const PlacedArm& placed, std::vector<Measurement>& measurements) {
  for (const auto& [name, members] : bySurface(measurements)) {
    Eigen::Matrix3Xd points_W(3, static_cast<Eigen::Index>(members.size()));
    for (std::size_t i = 0; i < members.size(); ++i) {
      const auto contact = contactOf(placed, measurements[members[i]]);
      if (!contact) return false;
      points_W.col(static_cast<Eigen::Index>(i)) = contact->p_W;
    }
    const Measurement& first = measurements[members.front()];
    Surface surface = first.surface.value_or(Surface{});
    if (!kindOf(first).settle(points_W, first, surface)) continue;
    for (const std::size_t k : members) measurements[k].surface = surface;
  }
  return true;
}

std::vector<SettledSurface> surfacesOf(const PlacedArm& placed, std::vector<Measurement> measurements) {
  std::vector<SettledSurface> surfaces;
  if (!settleSurfaces(placed, measurements)) return surfaces;
  for (const auto& [name, members] : bySurface(measurements)) {
    const Measurement& first = measurements[members.front()];
    if (!first.surface) continue;
    SettledSurface settled{kindOf(first).name, first.point, *first.surface, static_cast<int>(members.size()), 0};
    for (const std::size_t k : members) {
      const auto contact = contactOf(placed, measurements[k]);
      if (contact) settled.rms += kindOf(first).value(measurements[k], *contact).squaredNorm();
    }
    settled.rms = std::sqrt(settled.rms / static_cast<double>(members.size()));
    surfaces.push_back(std::move(settled));
  }
  return surfaces;
}

}  // namespace tubeplan::calibration
