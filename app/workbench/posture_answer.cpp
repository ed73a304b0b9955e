#include "app/workbench/posture_answer.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/documents/figures.hpp"
#include "app/documents/pose_json.hpp"
#include "app/formats/units.hpp"
#include "app/formats/units_json.hpp"
#include "app/storage/input_error.hpp"
#include "planner/collision/arm_clearance.hpp"
#include "planner/collision/deflection_travel.hpp"

namespace tubeplan::app {

namespace {

using Eigen::Isometry3d, Eigen::Vector3d;
using nlohmann::json;

json quaternionJson(const Eigen::Matrix3d& R) {
  const Eigen::Quaterniond turn(R);
  return {turn.w(), turn.x(), turn.y(), turn.z()};
}

json framesJson(const Cell& cell, const std::vector<Isometry3d>& X_WL) {
  json frames = json::array();
  for (std::size_t row = 0; row < X_WL.size(); ++row)
    frames.push_back({{"row", row},
                      {"position", vectorJson(X_WL[row].translation(), cell.units, dimension::kLength)},
                      {"quaternion", quaternionJson(X_WL[row].linear())}});
  return frames;
}

std::vector<Isometry3d> rigidFrames(const deflection::FlexibleKinematics& shape, const Isometry3d& X_WB) {
  std::vector<Isometry3d> frames;
  for (const auto& row : shape.rows) frames.push_back(X_WB * deflection::toIsometry(row.X_BL_rigid));
  return frames;
}

/// Returns the point of a shape nearest to the point `p` outside it, found by a step from `p` along the negative
/// gradient of the distance; the length of the step is the distance.
Vector3d nearestOn(const planner::Shape& shape, const Vector3d& p) {
  constexpr double kStep = 1e-5;  // step of the central differences [m]
  Vector3d slope;
  for (int k = 0; k < 3; ++k)
    slope[k] =
        (shape.pointDistance(p + kStep * Vector3d::Unit(k)) - shape.pointDistance(p - kStep * Vector3d::Unit(k))) /
        (2 * kStep);
  return slope.norm() > 0.1 ? Vector3d(p - shape.pointDistance(p) * slope.normalized()) : p;
}

/// Returns the nearest point, in the world frame, on the second object of a pair: an obstacle or a body.
std::optional<Vector3d> otherPoint(const planner::Scene& scene, const planner::Clearance& clearance,
                                   const deflection::PlacedRows& placed) {
  for (const auto& obstacle : scene.obstacles)
    if (obstacle.name == clearance.other) return nearestOn(*obstacle.shape, clearance.point_W);
  std::optional<Vector3d> nearest;
  for (const auto& body : scene.bodies) {  // consider all bodies, because several may have the same label
    if (planner::bodyLabel(body) != clearance.other) continue;
    const Isometry3d X = placed.X_WL(body.frame_index, 0);
    const Vector3d point = X * nearestOn(*body.shape, X.inverse() * clearance.point_W);
    if (!nearest || (point - clearance.point_W).norm() < (*nearest - clearance.point_W).norm()) nearest = point;
  }
  return nearest;
}

/// Returns the clearance as a plan computes it: reduced by the bow of deflected members and by the motion within joint
/// gaps.
json clearanceJson(const Model& model, const planner::Workcell& posed, const Eigen::VectorXd& q) {
  if (!model.pairs) return nullptr;
  const Units& units = model.cell.units;
  deflection::RowPlacing placing(posed.arm, posed.load, posed.X_WB);
  const deflection::PlacedRows& placed = placing.place(q);
  planner::NearestPair nearest;
  model.pairs->find(placed, {&nearest, 1});
  if (!std::isfinite(nearest.distance)) return nullptr;
  const planner::Clearance clearance = model.pairs->named(placed, 0, nearest);
  const double off = placed.bow.front() + planner::gapJumpOf(posed, planner::bodyReachOf(posed.scene));
  const auto other = otherPoint(posed.scene, clearance, placed);
  return {{"distance", lengthOf(clearance.distance - off, units)},
          {"margin", lengthOf(clearance.margin - off, units)},
          {"pair", {clearance.body, clearance.other}},
          {"from", vectorJson(clearance.point_W, units, dimension::kLength)},
          {"to", other ? vectorJson(*other, units, dimension::kLength) : json()}};
}

json centringOver(const Cell& cell, const Isometry3d& X_WD, int hole) {
  const auto& sheet = *cell.sheet;
  const Vector3d off = X_WD.translation() - planner::holeCentre(sheet.tubes.at(static_cast<std::size_t>(hole)));
  const double distance = off.head<2>().norm();
  const Vector3d axis_W = (X_WD.linear() * cell.arm.tool_axis_L).normalized();
  const double cosine = axis_W.dot(planner::kHoleAxis_W);
  const double sign = sheet.viewed_from == tubesheets::ViewedFrom::kBelow ? -1 : 1;
  return {
      {"offset", {lengthOf(sign * off.x(), cell.units), lengthOf(off.y(), cell.units)}},
      {"distance", lengthOf(distance, cell.units)},
      {"height", lengthOf(off.z(), cell.units)},
      {"steps",
       cell.tool ? json(tubesheets::stepsInserted(*cell.tool, off.head<2>(), axis_W.head<2>() / axis_W.z())) : json()},
      {"tilt", angleOf(std::acos(std::clamp(cosine, -1.0, 1.0)), cell.units)}};
}

}  // namespace

json answerPosture(const Model& model, const RequestedPosture& question) {
  const Cell& cell = model.cell;
  const deflection::Posture posture{question.q, question.load, deflection::gravityInBase(cell.arm, cell.X_WB)};
  const auto shape = deflection::solveFlexibleKinematics(cell.arm, posture);
  if (shape.status != deflection::KinematicsStatus::kConverged)
    throw InputError::problem("joints", shape.reason, "choose another posture or a smaller load");
  planner::Workcell posed = model.posed;
  posed.load = question.load;
  const auto bent = planner::bodyFrames(posed, question.q, nullptr);
  const Isometry3d X_WT = cell.X_WB * deflection::toIsometry(shape.X_BT),
                   X_WD = cell.X_WB * deflection::toIsometry(shape.X_BD);
  json answer = poseFiguresJson(shape, cell.units);
  answer["load"] = cell.units.toFile(question.load, dimension::kForce);
  answer["units"] = unitsJson(cell.units);
  answer["segments"] = segmentsJson(cell, posture, shape);
  answer["frames"] = {{"rigid", framesJson(cell, rigidFrames(shape, cell.X_WB))}, {"flexible", framesJson(cell, bent)}};
  answer["tip"] = {{"rigid", vectorJson(X_WT.translation(), cell.units, dimension::kLength)},
                   {"flexible", vectorJson(X_WD.translation(), cell.units, dimension::kLength)}};
  answer["clearance"] = clearanceJson(model, posed, question.q);
  answer["centring"] = question.hole && cell.sheet ? centringOver(cell, X_WD, *question.hole) : json();
  return answer;
}

json clearanceOf(const Model& model, const Eigen::VectorXd& q, double load) {
  planner::Workcell posed = model.posed;
  posed.load = load;
  return clearanceJson(model, posed, q);
}

}  // namespace tubeplan::app
