// The opening in the bowl through which people and arms come to a tube sheet.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "tubesheets/problem.hpp"
#include "tubesheets/tube.hpp"

namespace tubeplan::tubesheets {

/// A round opening whose axis goes through the middle of the sheet. [m], in the sheet frame of tube.hpp.
struct Manway {
  Eigen::Vector3d centre = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());  ///< in the bowl's skin
  double diameter = std::numeric_limits<double>::quiet_NaN();

  /// Where it lies as seen along the sheet's axis: a unit vector of the sheet's plane.
  [[nodiscard]] Eigen::Vector2d direction() const { return centre.head<2>().normalized(); }
};

/// Numbers that are not finite, an opening that is none, one that is not below the sheet, straight below its middle (it
/// then lies in no direction), in the other leg, or wider than the bowl that it would be in.
[[nodiscard]] std::vector<Problem> findManwayProblems(const Manway& manway, Leg leg);

}  // namespace tubeplan::tubesheets
