// Implementation of alignBases(): a first estimate of base poses in closed form, before any fit.
#include "calibration/estimation/fit.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "deflection/prepared_arm.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::Vector3d;

namespace {

constexpr int kMostAlignments = 12;
constexpr double kAligned = 1e-9;  // norm of the change of a base pose below which the alignment has converged

}  // namespace

void alignBases(PlacedArm& placed, const std::vector<Measurement>& measurements) {
  for (std::size_t p = 0; p < placed.base_poses.size(); ++p) {
    BasePose& base_pose = placed.base_poses[p];
    if (base_pose.is_known) continue;
    deflection::PreparedArm arm(placed.arm);
    for (int repeat = 0; repeat < kMostAlignments; ++repeat) {
      std::vector<Vector3d> tips, places;
      for (const auto& measurement : measurements) {
        const auto place = statedPlace(measurement);
        if (measurement.is_held_out || !place || basePoseOf(placed, measurement) != static_cast<int>(p)) continue;
        if (arm.solve(postureOf(measurement, placed.arm, base_pose.X_WB)) != deflection::KinematicsStatus::kConverged)
          continue;
        tips.push_back(arm.X_BD().p);
        places.push_back(*place);
      }
      if (tips.size() < 3) break;
      const auto n = static_cast<Index>(tips.size());
      const Eigen::Map<const Eigen::Matrix3Xd> from(tips.front().data(), 3, n), to(places.front().data(), 3, n);
      const Eigen::Matrix3Xd centred = from.colwise() - from.rowwise().mean();
      const auto spread = centred.jacobiSvd().singularValues();
      if (spread[1] < 1e-6 * spread[0]) break;  // all points are on one line, so the rotation about it is undetermined
      const Eigen::Isometry3d before = base_pose.X_WB;
      base_pose.X_WB = Eigen::Isometry3d(Eigen::umeyama(from, to, false));
      if ((base_pose.X_WB.matrix() - before.matrix()).norm() < kAligned) break;
    }
  }
}

}  // namespace tubeplan::calibration
