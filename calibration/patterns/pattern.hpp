// Variables that a residual may follow: the open table of what readings differ in. Each kind is a file here and a row
// of the table in patterns.cpp; nothing else names it.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "calibration/measurement.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// The readings, and the model's predictions beyond the error.
struct ReadingScene {
  bool ok = false;  ///< false: a deflected shape did not converge, and the rest is not to be used
  PlacedArm placed;
  std::vector<Measurement> readings;
  Eigen::Matrix3Xd tips;                 ///< predicted places in the world [m]
  Eigen::Matrix3Xd seen;                 ///< predicted places, or displacements from their reference [m]
  std::vector<Eigen::Matrix3d> tools;    ///< axes of the deflected tool frame, in the world
  std::vector<Eigen::Matrix3d> radials;  ///< axes away from the base's axis of gravity, around it, up; in the world
  /// Moments at each reading: one column for each row, in the row's own axes [N m].
  std::vector<Eigen::Matrix3Xd> moments_L;
};

/// Returns the slopes of a reading's rows by the tip's place in the world: by all three coordinates, or along the
/// measured line.
[[nodiscard]] inline MeasuredRows placeSlope(const ReadingScene& scene, std::size_t k) {
  return predictedSlope(scene.readings[k], {scene.seen.col(static_cast<Eigen::Index>(k)), scene.tools[k]}).by_place;
}

[[nodiscard]] ReadingScene observe(const PlacedArm& placed, const std::vector<Measurement>& readings);

/// A variable at all readings, and the small basis of its functions to test.
struct Variable {
  std::string name;  ///< "theta3", "moment forearm.z"
  deflection::ValueUnit unit;
  Eigen::VectorXd value;  ///< value at each reading, internal units; NaN if not stated; for groups, the group's number
  Eigen::MatrixXd basis;  ///< readings x functions; zero if not stated; empty for groups
  std::vector<std::string> groups;  ///< names of the groups, if the variable is a group
};

/// One row of the table.
struct PatternKind {
  const char* name;
  std::string needs;  ///< requirements of the test on the readings
  /// Function for the variables of the readings, empty if they do not have any.
  std::function<std::vector<Variable>(const ReadingScene&)> variables;
};

const std::vector<PatternKind>& patternKinds();

/// Returns a column of a function of the stated values, less its mean; zero if not stated.
[[nodiscard]] Eigen::VectorXd centred(const Eigen::VectorXd& value, double (*function)(double));

/// Returns true if the stated values differ by more than rounding.
[[nodiscard]] bool varies(const Eigen::VectorXd& value);

/// Returns the first waves from the variable's first value to its last: cos(k pi share), k = 1 to 3. They follow a
/// drift, a step and a slow swing alike.
[[nodiscard]] Eigen::MatrixXd slowWaves(const Eigen::VectorXd& value);

/// Returns the next waves, up to one cycle for eight readings and twelve at most; none if these would not exceed the
/// first.
[[nodiscard]] Eigen::MatrixXd fasterWaves(const Eigen::VectorXd& value);

/// Returns the name of a variable for errors that go through several of its cycles.
[[nodiscard]] inline std::string cyclesOf(const std::string& variable) { return "cycles of " + variable; }

/// Returns a variable of the group of each reading, with the names in order of first occurrence.
[[nodiscard]] Variable groupVariable(const std::string& name, const std::vector<std::string>& group_of_reading);

}  // namespace tubeplan::calibration
