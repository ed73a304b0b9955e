// Error that depends on a joint's reading.
//
// Basis of a revolute joint: sine and cosine with one cycle per turn, which over part of a turn resemble a straight
// line and an arc; two to four cycles per turn form a second variable. Basis of a prismatic joint: the length and its
// square.
#pragma once

#include <cmath>

#include "calibration/patterns/pattern.hpp"

namespace tubeplan::calibration::patterns::joint_reading {

inline constexpr double kBeyondNoise = 50;  // smallest range of a tested joint's readings, in encoder sigmas

inline std::vector<Variable> variables(const MeasurementScene& scene) {
  std::vector<Variable> list;
  for (Eigen::Index j = 0; j < scene.placed.arm.jointCount(); ++j) {
    const auto& joint = scene.placed.arm.joint(j);
    const bool slides = joint.type == deflection::JointType::kPrismatic;
    Variable variable{joint.name, {slides ? deflection::Quantity::kLength : deflection::Quantity::kAngle}, {}, {}, {}};
    variable.value.resize(static_cast<Eigen::Index>(scene.measurements.size()));
    for (std::size_t k = 0; k < scene.measurements.size(); ++k)
      variable.value[static_cast<Eigen::Index>(k)] = scene.measurements[k].q[j];
    const double range = variable.value.maxCoeff() - variable.value.minCoeff();
    if (!varies(variable.value) || range < kBeyondNoise * joint.encoder_sigma) continue;
    variable.basis.resize(variable.value.size(), 2);
    variable.basis.col(0) = centred(
        variable.value, slides ? [](double q) { return q; } : [](double q) { return std::sin(q); });
    variable.basis.col(1) = centred(
        variable.value, slides ? [](double q) { return q * q; } : [](double q) { return std::cos(q); });
    list.push_back(variable);
    if (slides) continue;
    variable.name = cyclesOf(joint.name);
    variable.basis.resize(variable.value.size(), 6);
    for (int cycle = 2; cycle <= 4; ++cycle) {
      const Eigen::VectorXd phase = cycle * variable.value;
      variable.basis.col(2 * cycle - 4) = centred(phase, [](double p) { return std::sin(p); });
      variable.basis.col(2 * cycle - 3) = centred(phase, [](double p) { return std::cos(p); });
    }
    list.push_back(std::move(variable));
  }
  return list;
}

inline PatternKind kind() { return {.name = "joint", .needs = "a joint that moves", .variables = variables}; }

}  // namespace tubeplan::calibration::patterns::joint_reading
