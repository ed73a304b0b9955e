// Units and column names of joint readings.
#pragma once

#include <Eigen/Core>
#include <string>

#include "app/formats/units.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

/// Returns the dimension of a joint's reading: a length for a prismatic joint, otherwise an angle.
[[nodiscard]] Dimension jointDimension(const deflection::Joint<double>& joint);

/// Returns the name of a joint's column without its unit: the joint's name, preceded by `joint_` if measurement tables
/// use that name for another quantity (`joint_x`).
[[nodiscard]] std::string jointColumnName(const deflection::Joint<double>& joint);

/// Returns the name of a joint's column in a file, including its unit: "theta1_deg", "lift_in".
[[nodiscard]] std::string jointColumn(const deflection::Joint<double>& joint, const Units& units);

/// Returns the factors that convert joint readings from file units to internal units, one for each active joint.
[[nodiscard]] Eigen::VectorXd jointFactors(const deflection::Arm& arm, const Units& units);

}  // namespace tubeplan::app
