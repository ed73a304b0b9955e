// What a joint's reading is measured in.
#pragma once

#include <Eigen/Core>
#include <string>

#include "app/formats/units.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

/// What a joint's reading is measured in: an angle, or a length for a prismatic one.
[[nodiscard]] Dimension jointDimension(const deflection::Joint<double>& joint);

/// What its columns are called before their unit: its name, or joint_x of a joint whose name a measurement table has
/// for another number with a unit.
[[nodiscard]] std::string jointColumnName(const deflection::Joint<double>& joint);

/// Its column in a file: theta1_deg, lift_in.
[[nodiscard]] std::string jointColumn(const deflection::Joint<double>& joint, const Units& units);

/// Factors from file to internal units, one per active joint.
[[nodiscard]] Eigen::VectorXd jointFactors(const deflection::Arm& arm, const Units& units);

}  // namespace tubeplan::app
