// Units and columns of joint readings.
#pragma once

#include <Eigen/Core>
#include <string>

#include "app/formats/units.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

/// Returns the dimension of a joint's reading: an angle, or a length for a prismatic joint.
[[nodiscard]] Dimension jointDimension(const deflection::Joint<double>& joint);

/// Returns the name of a joint's columns before their unit: the joint's name, or joint_x for a name that measurement
/// tables use for another quantity with a unit.
[[nodiscard]] std::string jointColumnName(const deflection::Joint<double>& joint);

/// Returns the name of a joint's column in a file: theta1_deg, lift_in.
[[nodiscard]] std::string jointColumn(const deflection::Joint<double>& joint, const Units& units);

/// Returns the factors from file to internal units, one per active joint.
[[nodiscard]] Eigen::VectorXd jointFactors(const deflection::Arm& arm, const Units& units);

}  // namespace tubeplan::app
