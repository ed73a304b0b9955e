// What a residual may follow: the open table of variables that readings differ in. Each kind is a file here and a row
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

/// The readings, and what the model says of each beyond the error.
struct ReadingScene {
  bool ok = false;  ///< whether every deflected shape settled; the rest is not to be used otherwise
  PlacedArm placed;
  std::vector<Measurement> readings;
  Eigen::Matrix3Xd tips;                    ///< predicted places, m, in the world
  Eigen::Matrix3Xd seen;                    ///< the same, or the ways to them from where the readings take them
  std::vector<Eigen::Matrix3d> tools;       ///< axes of the deflected tool frame, in the world
  std::vector<Eigen::Matrix3d> radials;     ///< away from the base's axis of gravity, around it, up; in the world
  std::vector<Eigen::Matrix3Xd> moments_L;  ///< of each reading: one column for each row, N m, in the row's own axes
};

/// How a reading's rows change with the tip's place in the world: by all three coordinates, or along the measured line.
[[nodiscard]] inline MeasuredRows placeSlope(const ReadingScene& scene, std::size_t k) {
  return predictedSlope(scene.readings[k], {scene.seen.col(static_cast<Eigen::Index>(k)), scene.tools[k]}).by_place;
}

[[nodiscard]] ReadingScene observe(const PlacedArm& placed, const std::vector<Measurement>& readings);

/// One variable at all readings, and the small basis of functions of it that is tried.
struct Variable {
  std::string name;  ///< "theta3", "moment forearm.z"
  deflection::ValueUnit unit;
  Eigen::VectorXd value;  ///< of each reading, internal units; NaN where not stated; of groups: the group's number
  Eigen::MatrixXd basis;  ///< readings x functions; zero where not stated; empty of groups
  std::vector<std::string> groups;  ///< names of the groups, where the variable is the group a reading belongs to
};

/// One row of the table.
struct PatternKind {
  const char* name;
  std::string needs;                                                    ///< what the readings must have to be asked
  std::function<std::vector<Variable>(const ReadingScene&)> variables;  ///< empty where the readings do not have it
};

const std::vector<PatternKind>& patternKinds();

/// One column of a function of the stated values, less its mean; zero where not stated.
[[nodiscard]] Eigen::VectorXd centred(const Eigen::VectorXd& value, double (*function)(double));

/// Whether the stated values differ by more than rounding.
[[nodiscard]] bool varies(const Eigen::VectorXd& value);

/// The first waves of a course from its first value to its last: cos(k pi share), k = 1 to 3. They follow a drift, a
/// step and a slow swing alike.
[[nodiscard]] Eigen::MatrixXd slowWaves(const Eigen::VectorXd& value);

/// The next waves of the course, up to one cycle for eight readings and twelve at most; none where those would be no
/// more than the first.
[[nodiscard]] Eigen::MatrixXd fasterWaves(const Eigen::VectorXd& value);

/// What a variable is called where the error goes through several cycles of it.
[[nodiscard]] inline std::string cyclesOf(const std::string& variable) { return "cycles of " + variable; }

/// A variable that says which group each reading belongs to; the names in their first order.
[[nodiscard]] Variable groupVariable(const std::string& name, const std::vector<std::string>& group_of_reading);

}  // namespace tubeplan::calibration
