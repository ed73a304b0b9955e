// Kinds of variables on which a residual may depend, as an extensible table. Each kind is one file in this folder and
// one row of the table in patterns.cpp; no other code refers to it.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "calibration/measurement.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Measurements with the model's predictions for them, except the residual.
struct MeasurementScene {
  bool ok = false;  ///< false if a deflected shape did not converge, and the other members are invalid
  PlacedArm placed;
  std::vector<Measurement> measurements;
  Eigen::Matrix3Xd tips;               ///< predicted tip positions in the world frame [m]
  Eigen::Matrix3Xd seen;               ///< predicted tip positions, or displacements from the reference [m]
  std::vector<Eigen::Matrix3d> tools;  ///< axes of the deflected tool frame, in the world frame
  /// Radial, tangential and upward unit vectors about the vertical through the base, in the world frame.
  std::vector<Eigen::Matrix3d> radials;
  /// Moments at each measurement, one column per row of the arm, in the row's own axes [N m].
  std::vector<Eigen::Matrix3Xd> moments_L;
};

/// Returns the derivatives of a measurement's rows with respect to the tip's position in the world frame. For a
/// distance, they are the unit vector along the measured line.
[[nodiscard]] inline MeasuredRows placeSlope(const MeasurementScene& scene, std::size_t k) {
  return predictedSlope(scene.measurements[k], {scene.seen.col(static_cast<Eigen::Index>(k)), scene.tools[k]}).by_place;
}

[[nodiscard]] MeasurementScene observe(const PlacedArm& placed, const std::vector<Measurement>& measurements);

/// Values of a variable at all measurements, and the few basis functions to test.
struct Variable {
  std::string name;  ///< name, such as "theta3" or "moment forearm.z"
  deflection::ValueUnit unit;
  /// Value of the variable at each measurement, in internal units; NaN if the measurement does not state it. For a
  /// variable that divides the measurements into groups: index of the measurement's group in `groups`.
  Eigen::VectorXd value;
  /// Basis functions at the measurements (measurements x functions); zero for a measurement that does not state the
  /// variable; empty for a variable with groups.
  Eigen::MatrixXd basis;
  std::vector<std::string> groups;  ///< names of the groups; empty for a variable without groups
};

/// A kind of pattern, which finds variables of one kind in the measurements: one row of the table.
struct PatternKind {
  const char* name;
  std::string needs;  ///< requirements of the test on the measurements
  /// Function that returns the variables of the measurements; empty if the measurements have none.
  std::function<std::vector<Variable>(const MeasurementScene&)> variables;
};

const std::vector<PatternKind>& patternKinds();

/// Returns `function` applied to each stated value, minus the mean of the results; zero where no value is stated.
[[nodiscard]] Eigen::VectorXd centred(const Eigen::VectorXd& value, double (*function)(double));

/// Returns true if the stated values differ beyond rounding.
[[nodiscard]] bool varies(const Eigen::VectorXd& value);

/// Returns the slowest waves over the variable's range: cos(k pi s), k = 1 to 3, with s the fraction of the range.
/// Together they represent a drift, a step or a slow oscillation.
[[nodiscard]] Eigen::MatrixXd slowWaves(const Eigen::VectorXd& value);

/// Returns the next faster waves: up to one cycle per eight measurements, and at most twelve cycles; empty if none of
/// these is faster than the slow waves.
[[nodiscard]] Eigen::MatrixXd fasterWaves(const Eigen::VectorXd& value);

/// Returns the name for errors that go through several cycles over a variable's range.
[[nodiscard]] inline std::string cyclesOf(const std::string& variable) { return "cycles of " + variable; }

/// Returns a grouping variable: the group of each measurement, with the names in the order of first occurrence.
[[nodiscard]] Variable groupVariable(const std::string& name, const std::vector<std::string>& group_of_measurement);

}  // namespace tubeplan::calibration
