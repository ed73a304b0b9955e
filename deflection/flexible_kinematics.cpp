#include "deflection/flexible_kinematics.hpp"

#include <algorithm>
#include <cmath>

#include "deflection/chain.hpp"
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

template <class S>
struct Load {
  Vector3<S> force = Vector3<S>::Zero();
  Vector3<S> moment = Vector3<S>::Zero();
};

template <class S>
Deflection<S> deflect(const ElementKind& kind, const Row<S>& row, const Loading<S>& loading) {
  if constexpr (std::is_same_v<S, double>)
    return kind.deflect(row, loading);
  else
    return kind.deflectDual(row, loading);
}

/// Moves the load in `carry` from a link's far frame to its near frame and deflects the link's element on the way
/// (steps 3, 4).
template <class S>
void resolveLink(const ArmOf<S>& arm, const PostureOf<S>& posture, const PoseOf<S>& near, const PoseOf<S>& far,
                 const ChainLink<S>& link, std::vector<ComponentStateOf<S>>& components, Load<S>& carry) {
  const Row<S>& row = arm.rows[link.row];
  const Vector3<S> r_B = far.p - near.p;
  const Vector3<S> weight_B = posture.gravity_B * link.weight;
  if (link.component >= 0) {
    const Matrix3<S> R_NB = near.R.transpose();
    const Loading<S> loading{R_NB * carry.force, R_NB * carry.moment, R_NB * weight_B, link.p, R_NB * r_B};
    ComponentStateOf<S>& component = components[link.component];
    const Deflection<S> deflection = deflect(elementKinds()[component.kind], row, loading);
    component.displacement = deflection.displacement;
    component.rotation = deflection.rotation;
  }
  carry.moment += r_B.cross(carry.force) + (r_B / S(2)).cross(weight_B);
  carry.force += weight_B;
  if (link.type == ChainLinkType::kLump) carry.moment += (near.R * link.lever).cross(weight_B);
}

template <class S>
void resolveLoads(const ArmOf<S>& arm, const PostureOf<S>& posture, const std::vector<PoseOf<S>>& frames,
                  Chain<S>& chain, std::vector<RowStateOf<S>>& rows) {
  Load<S> carry;
  carry.force = posture.gravity_B * posture.load;
  for (std::size_t k = chain.links.size(); k-- > 0;) {
    const ChainLink<S>& link = chain.links[k];
    resolveLink<S>(arm, posture, frames[k], frames[k + 1], link, chain.components, carry);
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

template <class S>
FlexibleKinematicsOf<S> iterate(const ArmOf<S>& arm, const PostureOf<S>& posture, Chain<S> chain, double reach,
                                const FlexibleKinematicsOptions& options) {
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
    resolveLoads(arm, posture, frames, chain, result.rows);
    combineTransforms(chain, false, frames);
    const double change = changeOf(frames.back(), before, reach);
    if (!std::isfinite(change)) break;
    if (change > tolerance) continue;
    result.status = KinematicsStatus::kConverged;
    break;
  }
  if (result.status != KinematicsStatus::kConverged)
    result.reason = "the deflected shape does not settle: the arm is too soft for its load";
  resolveLoads(arm, posture, frames, chain, result.rows);
  recordFrames(chain, frames, &RowStateOf<S>::X_BL, result.rows);
  result.X_BD = frames.back();
  result.components = std::move(chain.components);
  return result;
}

}  // namespace

FlexibleKinematics solveFlexibleKinematics(const Arm& arm, const Posture& posture,
                                           const FlexibleKinematicsOptions& options) {
  return iterate(arm, posture, assembleChain<double>(arm, arm, posture.q), reachOf(arm), options);
}

FlexibleKinematicsOf<Dual> solveFlexibleKinematics(const ArmOf<Dual>& arm, const PostureOf<Dual>& posture,
                                                   const FlexibleKinematics& values,
                                                   const FlexibleKinematicsOptions& options) {
  const Arm plain = castArm<double>(arm);
  Chain<Dual> chain = assembleChain<Dual>(arm, plain, posture.q);
  assert(chain.components.size() == values.components.size());
  for (std::size_t k = 0; k < chain.components.size(); ++k) {
    chain.components[k].displacement = values.components[k].displacement.cast<Dual>();
    chain.components[k].rotation = values.components[k].rotation.cast<Dual>();
  }
  return iterate(arm, posture, std::move(chain), reachOf(plain), options);
}

std::vector<Eigen::Isometry3d> rowFramesInWorld(const FlexibleKinematics& kinematics, const Eigen::Isometry3d& X_WB) {
  std::vector<Eigen::Isometry3d> frames;
  frames.reserve(kinematics.rows.size());
  for (const auto& row : kinematics.rows) frames.push_back(X_WB * toIsometry(row.X_BL));
  return frames;
}

}  // namespace tubeplan::deflection
