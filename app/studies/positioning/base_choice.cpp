#include "app/studies/positioning/base_choice.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

namespace tubeplan::app {

namespace {

using Eigen::Isometry3d, Eigen::Vector3d;

double valueAt(const BaseAxis& axis, int k) {
  return axis.count == 1 ? axis.from : axis.from + (axis.to - axis.from) * k / (axis.count - 1);
}

Isometry3d moved(Isometry3d X_WB, int axis, double value) {
  if (axis < 3)
    X_WB.translation()[axis] = value;
  else
    X_WB.linear() = Eigen::AngleAxisd(value, Vector3d::UnitZ()) * X_WB.linear();
  return X_WB;
}

/// Returns the mirror image of a pose in the plane where the coordinate `axis` is zero.
Isometry3d mirroredPose(const Isometry3d& X_WB, int axis) {
  Vector3d signs = Vector3d::Ones();
  signs[axis] = -1;
  Isometry3d X = Isometry3d::Identity();
  X.translation() = signs.cwiseProduct(X_WB.translation());
  X.linear() = signs.asDiagonal() * X_WB.linear() * signs.asDiagonal();
  return X;
}

planner::Workcell cellAt(planner::Workcell cell, const Isometry3d& X_WB, const std::vector<std::string>& moving) {
  cell.X_WB = X_WB;
  std::erase_if(cell.scene.obstacles, [&](const planner::Obstacle& obstacle) {
    return std::ranges::find(moving, obstacle.name) != moving.end();
  });
  return cell;
}

}  // namespace

std::vector<Isometry3d> baseCandidates(const Isometry3d& X_WB, const BaseChoiceOptions& options) {
  std::vector<Isometry3d> bases{X_WB};
  std::vector<Isometry3d> combined{X_WB};
  for (const BaseAxis& axis : options.axes) {
    std::vector<Isometry3d> next;
    for (const Isometry3d& X : combined)
      for (int k = 0; k < axis.count; ++k) next.push_back(moved(X, axis.axis, valueAt(axis, k)));
    combined = std::move(next);
  }
  if (!options.axes.empty()) bases.insert(bases.end(), combined.begin(), combined.end());
  for (const int axis : options.mirrored) {
    const std::vector<Isometry3d> own = bases;
    for (const Isometry3d& X : own) bases.push_back(mirroredPose(X, axis));
  }
  return bases;
}

BaseChoice chooseBases(const planner::Workcell& cell, const std::vector<int>& tubes, const BaseChoiceOptions& options,
                       const calibration::WorkHooks& hooks) {
  BaseChoice choice;
  choice.bases = baseCandidates(cell.X_WB, options);
  for (std::size_t c = 0; c < choice.bases.size() && !choice.is_stopped; ++c) {
    if (hooks.progress) hooks.progress("base positions", c, choice.bases.size());
    // Must outlive the ArmClearance that refers to it.
    const planner::Workcell at_base = cellAt(cell, choice.bases[c], options.moving);
    const planner::ArmClearance clearance(at_base, options.reach.padding);
    std::vector<char> reached(tubes.size(), 0);
    oneapi::tbb::parallel_for(std::size_t{0}, tubes.size(), [&](std::size_t t) {
      if (calibration::shouldStop(hooks.stop)) return;
      reached[t] = planner::reachTube(clearance, tubes[t], options.reach).status == planner::ReachStatus::kReachable;
    });
    choice.reaches.emplace_back(reached.begin(), reached.end());
    choice.is_stopped = calibration::shouldStop(hooks.stop);
  }
  if (!choice.is_stopped) choice.cover = planner::coverByBases(choice.reaches, options.cover);
  return choice;
}

}  // namespace tubeplan::app
