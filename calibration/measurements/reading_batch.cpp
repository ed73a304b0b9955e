#include "calibration/measurements/reading_batch.hpp"

#include <algorithm>

#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::Vector3d;

bool isForBatch(const deflection::Arm& arm, const std::vector<Measurement>& readings) {
  if (dependsOnPosture(arm)) return false;
  return std::none_of(readings.begin(), readings.end(), [](const Measurement& reading) {
    const Measurement* from = referenceOf(reading);
    return reading.row || reading.wrench || (from && from->wrench);
  });
}

void ReadingBatch::place(const Measurement& reading, double load, const Vector3d& gravity_B, Index at) {
  postures_.q.col(at) = reading.q;
  postures_.load[at] = load;
  postures_.gravity_B.col(at) = gravity_B;
}

bool ReadingBatch::solve(const std::vector<BasePose>& base_poses, const std::vector<Measurement>& readings,
                         const std::vector<int>& base_pose_of, std::size_t first, std::size_t count,
                         const std::vector<deflection::Variable>& variables) {
  if (count == 0) return true;
  std::vector<Vector3d> gravity_B;
  for (const auto& base_pose : base_poses) gravity_B.push_back(deflection::gravityInBase(arm_, base_pose.X_WB));
  from_.assign(count, -1);
  auto postures = static_cast<Index>(count);
  for (std::size_t k = 0; k < count; ++k)
    if (isDisplacement(readings[first + k])) from_[k] = postures++;
  postures_.resize(readings[first].q.size(), postures);
  for (std::size_t k = 0; k < count; ++k) {
    const Measurement& reading = readings[first + k];
    const Vector3d& gravity = gravity_B[static_cast<std::size_t>(base_pose_of[first + k])];
    place(reading, reading.load, gravity, static_cast<Index>(k));
    if (from_[k] < 0) continue;
    const auto from = departureOf(reading);
    place(*from->reading, from->is_unloaded ? 0 : from->reading->load, gravity, from_[k]);
  }
  kinematics_.solveWithDerivatives(postures_, variables, tips_);
  return std::all_of(tips_.status.begin(), tips_.status.end(),
                     [](auto status) { return status == deflection::KinematicsStatus::kConverged; });
}

Vector3d ReadingBatch::tip(std::size_t k) const {
  Vector3d p = tips_.poses.col(static_cast<Index>(k)).head<3>();
  if (from_[k] >= 0) p -= tips_.poses.col(from_[k]).head<3>();
  return p;
}

Vector3d ReadingBatch::column(std::size_t k, std::size_t variable) const {
  Vector3d by = ownColumn(k, variable);
  if (from_[k] >= 0) by -= referenceColumn(k, variable);
  return by;
}

ToolPose toolOf(const ReadingBatch& batch, std::size_t k, const Eigen::Isometry3d& X_WB, const Measurement& reading) {
  ToolPose tool;
  tool.p_W = X_WB.linear() * batch.tip(k);
  if (!isDisplacement(reading)) tool.p_W += X_WB.translation();
  if (seesTurn(reading)) tool.R_WT = X_WB.linear() * batch.turn(k);
  return tool;
}

}  // namespace tubeplan::calibration
