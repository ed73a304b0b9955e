#include "app/documents/pose_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/documents/figures.hpp"
#include "app/formats/arm/joint_units.hpp"
#include "deflection/discretisation.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::app {

PoseFigures poseFiguresOf(const deflection::PoseOf<double>& X) { return {X.p, deflection::fixedAnglesOf(X.R)}; }

PoseFigures rigidToolOf(const deflection::FlexibleKinematics& shape) {
  return {shape.X_BT.p, deflection::fixedAnglesOf(shape.X_BT.R * shape.R_LT)};
}

PoseFigures flexibleToolOf(const deflection::FlexibleKinematics& shape) {
  return {shape.X_BD.p, deflection::fixedAnglesOf(shape.X_BD.R * shape.R_LT)};
}

PoseFigures poseChange(const deflection::FlexibleKinematics& shape) {
  const PoseFigures rigid = rigidToolOf(shape), flexible = flexibleToolOf(shape);
  PoseFigures change{flexible.position - rigid.position, flexible.angles - rigid.angles};
  for (int k = 0; k < 3; ++k) change.angles[k] = std::remainder(change.angles[k], 2 * std::numbers::pi);
  return change;
}

nlohmann::json figuresJson(const PoseFigures& figures, const Units& units) {
  return {{"position", vectorJson(figures.position, units, dimension::kLength)},
          {"fixed_angles", vectorJson(figures.angles, units, dimension::kAngle)}};
}

nlohmann::json poseFiguresJson(const deflection::FlexibleKinematics& shape, const Units& units) {
  return {{"rigid", figuresJson(rigidToolOf(shape), units)},
          {"flexible", figuresJson(flexibleToolOf(shape), units)},
          {"change", figuresJson(poseChange(shape), units)},
          {"deflection", lengthJson(poseChange(shape).position.norm(), units)},
          {"iterations", shape.iterations}};
}

nlohmann::json jointValuesJson(const Eigen::VectorXd& q, const Cell& cell) {
  const Eigen::VectorXd values = q.cwiseQuotient(jointFactors(cell.arm, cell.units));
  return std::vector<double>(values.begin(), values.end());
}

nlohmann::json segmentsJson(const Cell& cell, const deflection::Posture& posture,
                            const deflection::FlexibleKinematics& shape) {
  constexpr double kOfDeflection = 0.01, kOfReach = 1e-9;
  const double sag = (shape.X_BD.p - shape.X_BT.p).norm();
  const double allowed = std::max(kOfDeflection * sag, kOfReach * deflection::reachOf(cell.arm));
  const auto found = deflection::discretisationOf(cell.arm, posture, allowed);
  const int needed = found.factor * deflection::mostSegments(cell.arm);
  std::string warning;
  if (found.factor != 1)
    warning = fmt::format(
        "the tip's discretisation error is about {:.2g} {}, {:.2g} % of its deflection, because its beams have too few "
        "segments{}",
        lengthOf(found.tip_error, cell.units), cell.units.length().name, 100 * found.tip_error / sag,
        found.factor == 0 ? "" : fmt::format(": set `segments: {}` in each beam", needed));
  return {{"tip_error", lengthJson(found.tip_error, cell.units)}, {"needed", needed}, {"warning", warning}};
}

nlohmann::json poseJson(const Eigen::Isometry3d& X, const Units& units) {
  const Eigen::Vector3d rpy = deflection::fixedAnglesOf(X.linear());
  return {{"position", vectorJson(X.translation(), units, dimension::kLength)},
          {"rpy", vectorJson(rpy, units, dimension::kAngle)}};
}

nlohmann::json standingJson(const BaseStanding& standing) {
  return {{"status", nameOf(standing.placing)},
          {"words", wordsOf(standing)},
          {"placed", isPlaced(standing)},
          {"touches", standing.touches}};
}

nlohmann::json eachRunJson(int touches, std::uint64_t misfits) {
  nlohmann::json base = standingJson(standingOfEachRun(touches));
  base["misfits"] = misfits;
  return base;
}

nlohmann::json placedBaseJson(const Eigen::Isometry3d& X_WB, const BaseStanding& standing, const Units& units) {
  nlohmann::json base = poseJson(X_WB, units);
  base.update(standingJson(standing));
  return base;
}

}  // namespace tubeplan::app
