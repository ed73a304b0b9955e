// Fit of touched planes and spheres of unknown place to the tips that touched them. The fit is exact at one state of
// the arm, so that an identification needs no variables for them.
#pragma once

#include <string>
#include <vector>

#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Returns true if any of the readings touches a surface of unknown place.
[[nodiscard]] bool touchSurfaces(const std::vector<Measurement>& readings);

/// Sets the surface of all its readings to the one nearest to the points that touched it, with the arm as it is.
/// Readings keep their surface if the points do not determine one. Returns false if a shape does not converge.
bool settleSurfaces(const PlacedArm& placed, std::vector<Measurement>& readings);

/// A fitted surface and the residual of its readings.
struct SettledSurface {
  std::string kind, point;
  Surface surface;
  int readings = 0;
  double rms = 0;  ///< root mean square of the readings' distances from it [m]
};

/// Returns the surfaces that the readings touch, in the order of their names, without those that are not determined.
[[nodiscard]] std::vector<SettledSurface> surfacesOf(const PlacedArm& placed, std::vector<Measurement> readings);

}  // namespace tubeplan::calibration
