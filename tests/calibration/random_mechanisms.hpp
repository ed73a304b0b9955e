// Rigid arms with random joint axes, in Denavit-Hartenberg and in other row conventions.
#pragma once

#include <numbers>

#include "calibration/placed_arm.hpp"
#include "calibration/random_stream.hpp"
#include "deflection/chain.hpp"
#include "deflection/row_conventions.hpp"

namespace tubeplan::calibration {

inline constexpr double kRightAngle = std::numbers::pi / 2;

/// Returns a random arm of three to eight joints in Denavit-Hartenberg rows. Each axis is parallel, nearly parallel,
/// perpendicular or at a random angle to the axis before; about a sixth of the joints are prismatic.
inline PlacedArm mechanism(std::uint64_t seed) {
  RandomStream random(seed);
  PlacedArm placed;
  const int joints = 3 + random.index(6);
  for (int k = 0; k < joints; ++k) {
    deflection::Row<double> row;
    row.name = "link" + std::to_string(k + 1);
    const double turns[] = {0, 0, 0.002, kRightAngle, -kRightAngle, random.uniform(0.5, 2.5)};
    deflection::DenavitHartenberg<double> dh{turns[random.index(6)], random.uniform(0.1, 0.5),
                                             random.index(2) * random.uniform(0.1, 0.4), 0};
    if (std::abs(dh.alpha) < 0.1 && random.index(2) == 0) dh.beta = random.uniform(-0.005, 0.005);
    const bool is_parallel = std::abs(dh.alpha) < 0.1;
    if (random.index(4) == 0 && !is_parallel) dh.a = 0;  // makes the axes intersect
    row.placement = dh;
    row.joint.name = "q" + std::to_string(k + 1);
    const bool follows_slide = k > 0 && placed.arm.rows.back().joint.type == deflection::JointType::kPrismatic;
    row.joint.type = random.index(6) == 0 && !(follows_slide && is_parallel) ? deflection::JointType::kPrismatic
                                                                             : deflection::JointType::kRevolute;
    const bool slides = row.joint.type == deflection::JointType::kPrismatic;
    row.joint.lower = slides ? 0.1 : -2.8;
    row.joint.upper = slides ? 0.6 : 2.8;
    placed.arm.rows.push_back(row);
  }
  placed.arm.p_LT = random.vector(0.1);
  placed.base_poses = {{"", Eigen::Isometry3d::Identity(), random.index(2) == 0}};
  return placed;
}

/// Returns the same arm with the frame of every row stated as an origin, as in URDF.
inline PlacedArm byOrigins(PlacedArm placed) {
  for (auto& row : placed.arm.rows) {
    const Eigen::Vector3d p = deflection::offsetInPreviousAxes<double>(row);
    row.placement =
        deflection::Origin<double>{p, deflection::fixedAnglesOf(deflection::rotationFromPrevious<double>(row))};
    row.placed_by.reset();
    row.is_written = true;
  }
  return placed;
}

/// Returns the arm that results if the given arm's Denavit-Hartenberg parameters are taken for standard ones.
inline PlacedArm byStandardTable(PlacedArm placed) {
  deflection::readAsStandard(placed.arm.rows);
  return placed;
}

}  // namespace tubeplan::calibration
