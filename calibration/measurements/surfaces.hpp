// Fit of touched planes and spheres of unknown position to the tips that touched them. The fit is exact at a given
// state of the arm, so that an identification needs no variables for the surfaces.
#pragma once

#include <string>
#include <vector>

#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Returns true if any of the measurements touches a surface of unknown position.
[[nodiscard]] bool touchSurfaces(const std::vector<Measurement>& measurements);

/// Fits every surface to the tips that touched it, as predicted with `placed`, and stores the surface in its
/// measurements. If the tips do not determine a surface, its measurements keep the previous one. Returns false if a
/// deflected shape does not converge.
bool settleSurfaces(const PlacedArm& placed, std::vector<Measurement>& measurements);

/// Fitted surface, with the residual of the measurements that touch it.
struct SettledSurface {
  std::string kind, point;
  Surface surface;
  int measurements = 0;
  double rms = 0;  ///< root mean square of the measurements' distances from the surface [m]
};

/// Returns the surfaces that the measurements touch, in the order of their names. Surfaces that the measurements do not
/// determine are omitted.
[[nodiscard]] std::vector<SettledSurface> surfacesOf(const PlacedArm& placed, std::vector<Measurement> measurements);

}  // namespace tubeplan::calibration
