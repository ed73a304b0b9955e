#include "deflection/flexible_kinematics.hpp"

#include <algorithm>
#include <cmath>

#include "deflection/effects/situation.hpp"
#include "deflection/sweeps.hpp"

namespace tubeplan::deflection {

namespace {

void resolveLoads(const Arm& arm, const Posture& posture, double reach, const std::vector<PoseOf<double>>& frames,
                  Chain<double>& chain, std::vector<RowState>& rows) {
  InwardSweep sweep = beginAtTip(arm, posture, reach, chain.clearances, frames.back());
  for (std::size_t k = chain.links.size(); k-- > 0;) {
    const ChainLink<double>& link = chain.links[k];
    resolveLink(sweep, frames[k], frames[k + 1], link, chain.components);
    if (link.type != ChainLinkType::kFrame) continue;
    RowState& row = rows[link.row];
    row.force_B = sweep.carry.force;
    row.moment_B = sweep.carry.moment;
    row.force_L = frames[k].R.transpose() * sweep.carry.force;
    row.moment_L = frames[k].R.transpose() * sweep.carry.moment;
  }
}

/// Largest change of the tip between two passes [m].
double changeOf(const PoseOf<double>& now, const PoseOf<double>& before, double reach) {
  return std::max((now.p - before.p).norm(), reach * (now.R - before.R).norm());
}

void recordFrames(const Chain<double>& chain, const std::vector<PoseOf<double>>& frames,
                  PoseOf<double> RowState::*where, std::vector<RowState>& rows) {
  for (std::size_t k = 0; k < chain.links.size(); ++k)
    if (chain.links[k].type == ChainLinkType::kFrame) rows[chain.links[k].row].*where = frames[k];
}

FlexibleKinematics iterate(const Arm& arm, const Posture& posture, const FlexibleKinematicsOptions& options) {
  FlexibleKinematics result;
  result.rows.resize(arm.rows.size());
  Chain<double> chain = assembleChain<double>(arm, arm, posture.q);
  const double reach = reachOf(arm), tolerance = options.tolerance * reach;
  std::vector<PoseOf<double>> frames;
  combineTransforms(chain, true, frames);
  recordFrames(chain, frames, &RowState::X_BL_rigid, result.rows);
  result.X_BT = frames.back();
  combineTransforms(chain, false, frames);
  result.status = KinematicsStatus::kNotConverged;
  for (result.iterations = 1; result.iterations <= options.max_iterations; ++result.iterations) {
    const PoseOf<double> before = frames.back();
    resolveLoads(arm, posture, reach, frames, chain, result.rows);
    combineTransforms(chain, false, frames);
    const double change = changeOf(frames.back(), before, reach);
    if (!std::isfinite(change)) break;
    if (change > tolerance) continue;
    result.status = KinematicsStatus::kConverged;
    break;
  }
  if (result.status != KinematicsStatus::kConverged)
    result.reason = "the deflected shape does not settle: the arm is too soft for its load";
  resolveLoads(arm, posture, reach, frames, chain, result.rows);
  recordFrames(chain, frames, &RowState::X_BL, result.rows);
  result.X_BD = frames.back();
  result.components = std::move(chain.components);
  return result;
}

/// No shape: its numbers are not to be used.
FlexibleKinematics undefinedShape(const Arm& arm, const std::string& reason) {
  FlexibleKinematics result;
  result.status = KinematicsStatus::kUndefined;
  result.reason = reason;
  result.rows.resize(arm.rows.size());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  result.X_BT.p = result.X_BD.p = Eigen::Vector3d::Constant(nan);
  return result;
}

/// From the axes of the moved base M to those of the base as named.
void moveBase(const PoseOf<double>& X_BM, FlexibleKinematics& shape) {
  shape.X_BT = X_BM * shape.X_BT;
  shape.X_BD = X_BM * shape.X_BD;
  for (auto& row : shape.rows) {
    row.X_BL_rigid = X_BM * row.X_BL_rigid;
    row.X_BL = X_BM * row.X_BL;
    row.force_B = X_BM.R * row.force_B;
    row.moment_B = X_BM.R * row.moment_B;
  }
}

}  // namespace

FlexibleKinematics solveFlexibleKinematics(const Arm& arm, const Posture& posture,
                                           const FlexibleKinematicsOptions& options) {
  if (arm.effects.empty()) return iterate(arm, posture, options);
  const Situation<double> situation = situationOf(arm, posture);
  if (!situation.undefined.empty()) return undefinedShape(arm, situation.undefined);
  FlexibleKinematics result = iterate(situation.arm, situation.posture, options);
  moveBase(situation.X_BM, result);
  return result;
}

std::vector<Eigen::Isometry3d> rowFramesInWorld(const FlexibleKinematics& kinematics, const Eigen::Isometry3d& X_WB) {
  std::vector<Eigen::Isometry3d> frames;
  frames.reserve(kinematics.rows.size());
  for (const auto& row : kinematics.rows) frames.push_back(X_WB * toIsometry(row.X_BL));
  return frames;
}

}  // namespace tubeplan::deflection
