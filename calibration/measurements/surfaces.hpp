// Touched planes and spheres of unknown place, found from the tips that touched them: exactly at one state of the arm,
// so that a fit has no variables for them.
#pragma once

#include <string>
#include <vector>

#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Whether any of the readings touches one.
[[nodiscard]] bool touchSurfaces(const std::vector<Measurement>& readings);

/// Gives all readings of a surface the one that lies nearest to the points that touched it, the arm being as it is;
/// where those do not determine one, readings keep what they have. False where a shape does not converge.
bool settleSurfaces(const PlacedArm& placed, std::vector<Measurement>& readings);

/// A settled surface, and how well its readings lie on it.
struct SettledSurface {
  std::string kind, point;
  Surface surface;
  int readings = 0;
  double rms = 0;  ///< m, of the readings' distances from it
};

/// Returns the surfaces that the readings touch, in the order of their names; none whose place is not determined.
[[nodiscard]] std::vector<SettledSurface> surfacesOf(const PlacedArm& placed, std::vector<Measurement> readings);

}  // namespace tubeplan::calibration
