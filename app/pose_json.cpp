#include "app/pose_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/command_inputs.hpp"

namespace tubeplan::app {

PoseFigures poseFiguresOf(const deflection::PoseOf<double>& X) { return {X.p, deflection::fixedAnglesOf(X.R)}; }

PoseFigures poseChange(const deflection::FlexibleKinematics& shape) {
  const PoseFigures rigid = poseFiguresOf(shape.X_BT), flexible = poseFiguresOf(shape.X_BD);
  PoseFigures change{flexible.position - rigid.position, flexible.angles - rigid.angles};
  for (int k = 0; k < 3; ++k) change.angles[k] = std::remainder(change.angles[k], 2 * std::numbers::pi);
  return change;
}

nlohmann::json figuresJson(const PoseFigures& figures, const Units& units) {
  return {{"position", vectorJson(figures.position, units, dimension::kLength)},
          {"fixed_angles", vectorJson(figures.angles, units, dimension::kAngle)}};
}

nlohmann::json poseFiguresJson(const deflection::FlexibleKinematics& shape, const Units& units) {
  return {{"rigid", figuresJson(poseFiguresOf(shape.X_BT), units)},
          {"flexible", figuresJson(poseFiguresOf(shape.X_BD), units)},
          {"change", figuresJson(poseChange(shape), units)},
          {"iterations", shape.iterations}};
}

}  // namespace tubeplan::app
