#include "app/documents/leverage_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/documents/figure_units.hpp"
#include "app/documents/figures.hpp"
#include "app/storage/input_error.hpp"
#include "app/studies/model/cell_fit.hpp"
#include "calibration/measurements/measurement_prediction.hpp"

namespace tubeplan::app {

namespace {

using Eigen::Isometry3d, Eigen::Vector3d;
using nlohmann::json;

/// Axis about which the tip rotates, or along which it moves.
struct Lever {
  int row = -1;
  int axis = 2;  ///< index of an axis of the row's frame (0: x, 1: y, 2: z)
  bool slides = false;
};

std::optional<Lever> findLever(const deflection::Arm& arm, const std::string& name) {
  for (std::size_t row = 0; row < arm.rows.size(); ++row) {
    const auto& own = arm.rows[row];
    const int index = static_cast<int>(row);
    if (!own.joint.name.empty() && own.joint.name == name)  // a joint acts about, or along, the z axis of its row
      return Lever{index, 2, own.joint.type == deflection::JointType::kPrismatic};
    for (int k = 0; k < 3; ++k)
      if (name == own.name + "." + "xyz"[k]) return Lever{index, k, false};
  }
  return std::nullopt;
}

std::vector<Lever> leversOf(const deflection::Arm& arm, const std::vector<std::string>& names) {
  std::vector<Lever> levers;
  for (const auto& name : names) {
    const auto lever = findLever(arm, name);
    if (!lever) throw InputError("at", inQuotes(name), "a joint of this arm, or an axis of a row such as 'forearm.z'");
    levers.push_back(*lever);
  }
  return levers;
}

/// Returns the displacement of the tip in the world frame, per radian of rotation [m/rad] or per metre of translation.
Vector3d leverage(const Lever& lever, const Isometry3d& X_WL, const Vector3d& p_WT) {
  const Vector3d axis_W = X_WL.linear().col(lever.axis);
  return lever.slides ? axis_W : Vector3d(axis_W.cross(p_WT - X_WL.translation()));
}

/// Rounds to six decimals, which suffice for plots and keep the JSON of many measurements small.
double roundedTo6(double value) { return std::round(value * 1e6) / 1e6; }

json vectorOf(const Vector3d& v) { return {roundedTo6(v.x()), roundedTo6(v.y()), roundedTo6(v.z())}; }

}  // namespace

bool isAxisOfRow(const deflection::Arm& arm, const std::string& at) {
  const auto dot = at.rfind('.');
  return dot != std::string::npos && findLever(arm, at).has_value();
}

json leverageJson(const Cell& cell, const std::vector<calibration::Measurement>& all,
                  const std::vector<std::string>& names) {
  const auto placed = placedWhereRead(cell, all);
  const auto levers = leversOf(cell.arm, names);
  const double turn = cell.units.factor(dimension::kAngle) / cell.units.factor(dimension::kLength);
  json tools = json::object(), measurements = json::object();
  for (const auto& measurement : all) {
    const Isometry3d& X_WB = placed.base_poses[static_cast<std::size_t>(basePoseOf(placed, measurement))].X_WB;
    const auto shape =
        deflection::solveFlexibleKinematics(cell.arm, calibration::postureOf(measurement, cell.arm, X_WB));
    if (shape.status != deflection::KinematicsStatus::kConverged) continue;
    const auto X_WL = deflection::rowFramesInWorld(shape, X_WB);
    const Isometry3d X_WD = X_WB * deflection::toIsometry(shape.X_BD);
    json numbers = json::array(), axes = json::array();
    for (const auto& lever : levers)
      for (const double part : leverage(lever, X_WL[static_cast<std::size_t>(lever.row)], X_WD.translation()))
        numbers.push_back(roundedTo6(part * (lever.slides ? 1 : turn)));
    for (const double part : X_WD.linear().reshaped()) axes.push_back(roundedTo6(part));
    measurements[measurement.id] = std::move(numbers);
    tools[measurement.id] = std::move(axes);
  }
  json units = json::array(), units_of_each = json::array();
  for (const auto& lever : levers) {
    const std::string by = cell.units.nameOf(lever.slides ? dimension::kLength : dimension::kAngle);
    units.push_back(by);
    units_of_each.insert(units_of_each.end(), 3, fmt::format("{}/{}", cell.units.length().name, by));
  }
  const Isometry3d& X_WB = placed.base_poses.empty() ? cell.X_WB : placed.base_poses.front().X_WB;
  return {{"units", units},
          {"names", names},
          {"base", vectorJson(X_WB.translation(), cell.units, dimension::kLength)},
          {"up", vectorOf(-cell.arm.gravity_W.normalized())},
          {"tool", tools},
          {"unit", kOfEachNumber},
          {"units_of_each", units_of_each},
          {"readings", measurements}};
}

}  // namespace tubeplan::app
