#include "deflection/flexible_kinematics.hpp"

#include <algorithm>
#include <cmath>

#include "deflection/chain.hpp"
#include "deflection/effects/situation.hpp"
#include "deflection/elements/clearance.hpp"
#include "deflection/parameters.hpp"

namespace tubeplan::deflection {

namespace {

/// Far frames of all links, `frames[0]` the base. Rigid where `components` is empty.
template <class S>
void combineTransforms(const Chain<S>& chain, bool rigid, std::vector<PoseOf<S>>& frames) {
  frames.resize(chain.links.size() + 1);
  frames[0] = {};
  for (std::size_t k = 0; k < chain.links.size(); ++k) {
    const ChainLink<S>& link = chain.links[k];
    PoseOf<S> X = frames[k];
    Vector3<S> p = link.p;
    if (!rigid && link.component >= 0) p += chain.components[link.component].displacement;
    X.p += X.R * p;
    if (link.type == ChainLinkType::kTurn) X.R = X.R * link.R;
    if (!rigid && link.component >= 0) X.R = X.R * rotationFromVector<S>(chain.components[link.component].rotation);
    frames[k + 1] = X;
  }
}

/// How everything beyond a place pulls back when it is turned about it, and how hard at most. Plain numbers: they steer
/// the clearances only.
struct Restoring {
  Eigen::Matrix3d virial = Eigen::Matrix3d::Zero();  ///< sum of r F^T, r from the place to the force [N m], base axes
  double forces = 0;                                 ///< sum of the forces' sizes [N]

  void add(const Eigen::Vector3d& r, const Eigen::Vector3d& force) {
    virial += r * force.transpose();
    forces += force.norm();
  }

  /// Change of the moment about n with a turn about n: n . sum (n x r) x F.
  [[nodiscard]] double momentPerAngle(const Eigen::Vector3d& n) const {
    return n.dot(virial.transpose() * n) - virial.trace();
  }
};

template <class S>
struct Load {
  Vector3<S> force = Vector3<S>::Zero();
  Vector3<S> moment = Vector3<S>::Zero();
  Restoring restoring;
};

template <class S>
Deflection<S> deflect(const ElementKind& kind, const Row<S>& row, const Loading<S>& loading) {
  if constexpr (std::is_same_v<S, double>)
    return kind.deflect(row, loading);
  else
    return kind.deflectDual(row, loading);
}

/// One inward sweep over the chain: what it reads of the arm, and the load it carries.
template <class S>
struct Sweep {
  const ArmOf<S>& arm;
  const PostureOf<S>& posture;
  double reach;
  int clearances;
  Load<S> carry;
};

/// The axes of a joint with clearance moved within it, by the moment in near-end axes.
template <class S>
void settleClearances(const Sweep<S>& sweep, const Row<S>& row, const Matrix3<S>& near_R, const Vector3<S>& moment,
                      ComponentStateOf<S>& component) {
  const double scale = sweep.carry.restoring.forces * sweep.reach;
  for (int k = 0; k < 3; ++k) {
    if (!row.addition->has_gap[k]) continue;
    const Eigen::Vector3d axis = valuesOf(near_R.col(k));
    component.gap[k] = clearance::settle<S>(
        row.addition->gap[k], component.gap[k], moment[k],
        {sweep.carry.restoring.momentPerAngle(axis), scale, sweep.clearances});
  }
  component.rotation += component.gap;
}

/// Moves what pulls back from a link's far frame to its near frame; before the load itself is moved.
template <class S>
void carryRestoring(Load<S>& carry, const Row<S>& row, const PoseOf<S>& near, const ChainLink<S>& link,
                    const Eigen::Vector3d& r_B, const Eigen::Vector3d& weight_B) {
  carry.restoring.virial += r_B * valuesOf(carry.force).transpose();
  const bool hangs_aside = link.type == ChainLinkType::kLump;
  carry.restoring.add(hangs_aside ? (valuesOf(near.R) * valuesOf(link.lever)).eval() : (r_B / 2).eval(), weight_B);
  if (link.type == ChainLinkType::kEndWeight && row.addition)
    carry.restoring.add(Eigen::Vector3d::Zero(), valuesOf(row.addition->pull));
}

/// Moves the load from a link's far frame to its near frame and deflects the link's element on the way (steps 3, 4).
template <class S>
void resolveLink(Sweep<S>& sweep, const PoseOf<S>& near, const PoseOf<S>& far, const ChainLink<S>& link,
                 std::vector<ComponentStateOf<S>>& components) {
  const Row<S>& row = sweep.arm.rows[link.row];
  Load<S>& carry = sweep.carry;
  const Vector3<S> r_B = far.p - near.p;
  const Vector3<S> weight_B = sweep.posture.gravity_B * link.weight;
  if (link.component >= 0) {
    const Matrix3<S> R_NB = near.R.transpose();
    const Loading<S> loading{R_NB * carry.force, R_NB * carry.moment, R_NB * weight_B, link.p, R_NB * r_B};
    ComponentStateOf<S>& component = components[link.component];
    const Deflection<S> deflection = deflect(elementKinds()[component.kind], row, loading);
    component.displacement = deflection.displacement;
    component.rotation = deflection.rotation;
    if (link.type == ChainLinkType::kFlexJoint && row.addition)
      settleClearances(sweep, row, near.R, loading.moment, component);
  }
  if (sweep.clearances > 0) carryRestoring(carry, row, near, link, valuesOf(r_B), valuesOf(weight_B));
  carry.moment += r_B.cross(carry.force) + (r_B / S(2)).cross(weight_B);
  carry.force += weight_B;
  if (link.type == ChainLinkType::kLump) carry.moment += (near.R * link.lever).cross(weight_B);
  if (link.type == ChainLinkType::kEndWeight && row.addition) carry.force += row.addition->pull;
}

/// The load at the tip: the hung one, and what effects add there.
template <class S>
Load<S> loadAtTip(const ArmOf<S>& arm, const PostureOf<S>& posture, const PoseOf<S>& tip) {
  Load<S> load;
  load.force = posture.gravity_B * posture.load;
  Vector3<S> lever_B = Vector3<S>::Zero();
  if (arm.tip_load) {
    lever_B = tip.R * arm.tip_load->payload_offset;
    load.moment = lever_B.cross(load.force);
  }
  load.restoring.add(valuesOf(lever_B), valuesOf(load.force));
  if (!arm.tip_load) return load;
  const Vector3<S> contact_B = posture.gravity_B * S(-arm.tip_load->contact_force);
  load.force += contact_B;
  load.restoring.add(Eigen::Vector3d::Zero(), valuesOf(contact_B));
  return load;
}

template <class S>
void resolveLoads(const ArmOf<S>& arm, const PostureOf<S>& posture, double reach,
                  const std::vector<PoseOf<S>>& frames, Chain<S>& chain, std::vector<RowStateOf<S>>& rows) {
  Sweep<S> sweep{arm, posture, reach, chain.clearances, loadAtTip(arm, posture, frames.back())};
  const Load<S>& carry = sweep.carry;
  for (std::size_t k = chain.links.size(); k-- > 0;) {
    const ChainLink<S>& link = chain.links[k];
    resolveLink<S>(sweep, frames[k], frames[k + 1], link, chain.components);
    if (link.type != ChainLinkType::kFrame) continue;
    RowStateOf<S>& row = rows[link.row];
    row.force_B = carry.force;
    row.moment_B = carry.moment;
    row.force_L = frames[k].R.transpose() * carry.force;
    row.moment_L = frames[k].R.transpose() * carry.moment;
  }
}

/// Largest change of the tip between two passes: metres, and for duals the relative change of every derivative.
double changeOf(const PoseOf<double>& now, const PoseOf<double>& before, double reach) {
  return std::max((now.p - before.p).norm(), reach * (now.R - before.R).norm());
}

double changeOf(const PoseOf<Dual>& now, const PoseOf<Dual>& before, double reach) {
  double change = (valuesOf(now.p) - valuesOf(before.p)).norm();
  for (int d = 0; d < kDualSize; ++d) {
    double size = 0, step = 0;
    for (int k = 0; k < 3; ++k) {
      size = std::max(size, std::abs(now.p[k].derivatives()[d]));
      step = std::max(step, std::abs(now.p[k].derivatives()[d] - before.p[k].derivatives()[d]));
      for (int j = 0; j < 3; ++j) {
        size = std::max(size, reach * std::abs(now.R(k, j).derivatives()[d]));
        step = std::max(step, reach * std::abs(now.R(k, j).derivatives()[d] - before.R(k, j).derivatives()[d]));
      }
    }
    if (size > 0) change = std::max(change, reach * step / size);
  }
  return change;
}

template <class S>
void recordFrames(const Chain<S>& chain, const std::vector<PoseOf<S>>& frames, PoseOf<S> RowStateOf<S>::*where,
                  std::vector<RowStateOf<S>>& rows) {
  for (std::size_t k = 0; k < chain.links.size(); ++k)
    if (chain.links[k].type == ChainLinkType::kFrame) rows[chain.links[k].row].*where = frames[k];
}

/// Passes until the tip rests, or after `enough` of them.
template <class S>
FlexibleKinematicsOf<S> iterate(const ArmOf<S>& arm, const PostureOf<S>& posture, Chain<S> chain, double reach,
                                int enough, const FlexibleKinematicsOptions& options) {
  FlexibleKinematicsOf<S> result;
  result.rows.resize(arm.rows.size());
  std::vector<PoseOf<S>> frames;
  combineTransforms(chain, true, frames);
  recordFrames(chain, frames, &RowStateOf<S>::X_BL_rigid, result.rows);
  result.X_BT = frames.back();
  combineTransforms(chain, false, frames);
  result.status = KinematicsStatus::kNotConverged;
  // Derivatives carry the rounding of every pass: asking more of them than this never ends.
  const double tolerance = std::max(options.tolerance, std::is_same_v<S, double> ? 0 : 1e-13) * reach;
  for (result.iterations = 1; result.iterations <= options.max_iterations; ++result.iterations) {
    const PoseOf<S> before = frames.back();
    resolveLoads(arm, posture, reach, frames, chain, result.rows);
    combineTransforms(chain, false, frames);
    const double change = changeOf(frames.back(), before, reach);
    if (!std::isfinite(change)) break;
    if (change > tolerance && result.iterations < enough) continue;
    result.status = KinematicsStatus::kConverged;
    break;
  }
  if (result.status != KinematicsStatus::kConverged)
    result.reason = "the deflected shape does not settle: the arm is too soft for its load";
  resolveLoads(arm, posture, reach, frames, chain, result.rows);
  recordFrames(chain, frames, &RowStateOf<S>::X_BL, result.rows);
  result.X_BD = frames.back();
  result.components = std::move(chain.components);
  return result;
}

FlexibleKinematics solvePlain(const Arm& arm, const Posture& posture, const FlexibleKinematicsOptions& options) {
  return iterate(arm, posture, assembleChain<double>(arm, arm, posture.q), reachOf(arm), options.max_iterations + 1, options);
}

FlexibleKinematicsOf<Dual> solvePlain(const ArmOf<Dual>& arm, const PostureOf<Dual>& posture,
                                      const FlexibleKinematics& values, const FlexibleKinematicsOptions& options) {
  const Arm plain = castArm<double>(arm);
  Chain<Dual> chain = assembleChain<Dual>(arm, plain, posture.q);
  assert(chain.components.size() == values.components.size());
  for (std::size_t k = 0; k < chain.components.size(); ++k) {
    chain.components[k].displacement = values.components[k].displacement.cast<Dual>();
    chain.components[k].rotation = values.components[k].rotation.cast<Dual>();
    chain.components[k].gap = values.components[k].gap.cast<Dual>();
  }
  // Derivatives close in as fast as the values did. What still moves after twice as many passes is the rounding of a
  // derivative that is zero, which never rests relative to itself.
  const int enough = 2 * values.iterations + 10;
  return iterate(arm, posture, std::move(chain), reachOf(plain), enough, options);
}

/// From the axes of the moved base M to those of the base as named.
template <class S>
void moveBase(const PoseOf<S>& X_BM, FlexibleKinematicsOf<S>& shape) {
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
  if (arm.effects.empty()) return solvePlain(arm, posture, options);
  const Situation<double> situation = situationOf(arm, posture);
  FlexibleKinematics result = solvePlain(situation.arm, situation.posture, options);
  moveBase(situation.X_BM, result);
  return result;
}

FlexibleKinematicsOf<Dual> solveFlexibleKinematics(const ArmOf<Dual>& arm, const PostureOf<Dual>& posture,
                                                   const FlexibleKinematics& values,
                                                   const FlexibleKinematicsOptions& options) {
  if (arm.effects.empty()) return solvePlain(arm, posture, values, options);
  const Situation<Dual> situation = situationOf(arm, posture);
  FlexibleKinematicsOf<Dual> result = solvePlain(situation.arm, situation.posture, values, options);
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
