// The manway: the opening in the bowl below the sheet through which people and arms enter.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "tubesheets/problem.hpp"
#include "tubesheets/tube.hpp"

namespace tubeplan::tubesheets {

/// A round opening of the bowl whose axis passes through the centre of the sheet [m], in the sheet frame of tube.hpp.
struct Manway {
  /// Centre of the opening on the bowl's surface.
  Eigen::Vector3d centre = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  double diameter = std::numeric_limits<double>::quiet_NaN();

  /// Returns the direction of the opening as seen along the sheet's axis: a unit vector in the plane of the sheet.
  [[nodiscard]] Eigen::Vector2d direction() const { return centre.head<2>().normalized(); }
};

/// Returns the problems of a manway: values that are not finite, a diameter not above zero, an opening wider than the
/// bowl, and a centre that is not below the sheet, that lies on the sheet's axis (and therefore has no direction), or
/// that is in the other leg.
[[nodiscard]] std::vector<Problem> findManwayProblems(const Manway& manway, Leg leg);

}  // namespace tubeplan::tubesheets
