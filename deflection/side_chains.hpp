// Parts that branch off a row and do not lead to the tip: a second arm, or a counterweight with its own joint.
//
// Law: a side chain is rigid and only adds its weight at its centre of gravity. The centre, in the axes of the row that
//      carries the chain, follows from the readings of the chain's own joints.
// Validity: deflections within the chain move its centre of gravity only slightly.
// Source: statics.
#pragma once

#include <algorithm>

#include "deflection/chain.hpp"

namespace tubeplan::deflection {

/// Returns the joints of all side chains that have readings of their own, in file order, as in Posture::side_q.
template <class S>
std::vector<const Joint<S>*> sideJoints(const ArmOf<S>& arm) {
  std::vector<const Joint<S>*> joints;
  for (const auto& chain : arm.side_chains)
    for (const auto& row : chain.rows)
      if (row.joint.type != JointType::kPassive) joints.push_back(&row.joint);
  return joints;
}

/// Returns the readings that replace unknown readings of sideJoints(): zero, or the joint limit nearest to zero.
template <class S>
Eigen::VectorXd defaultSideReadings(const ArmOf<S>& arm) {
  const auto joints = sideJoints(arm);
  Eigen::VectorXd q(static_cast<Eigen::Index>(joints.size()));
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    const auto& joint = *joints[static_cast<std::size_t>(k)];
    q[k] = std::clamp(0., joint.lower, joint.upper);
  }
  return q;
}

/// Returns the weight of a side chain [N] and its point of action, in the axes of the row that carries the chain. `q`
/// holds the readings of all side joints; `joint` is the index of this chain's first joint, and is advanced to the next
/// chain's first.
template <class S>
Lump<S> weightOfSideChain(const SideChain<S>& chain, const Eigen::Matrix<S, Eigen::Dynamic, 1>& q,
                          Eigen::Index& joint) {
  S weight(0);
  Vector3<S> moment = Vector3<S>::Zero(), p = Vector3<S>::Zero();
  Matrix3<S> R = Matrix3<S>::Identity();
  const auto attach = [&](const S& size, const Vector3<S>& at) {
    weight += size;
    moment += at * size;
  };
  for (std::size_t k = 0; k < chain.rows.size(); ++k) {
    const Row<S>& row = chain.rows[k];
    p += R * offsetInPreviousAxes<S>(row);
    R = (R * rotationFromPrevious<S>(row)).eval();
    if (row.joint.type != JointType::kPassive) {
      const S reading = q[joint++] + row.joint.offset;
      if (row.joint.type == JointType::kRevolute) R = (R * rotationZ<S>(reading)).eval();
      if (row.joint.type == JointType::kPrismatic) p += R.col(2) * reading;
    }
    for (const auto& lump : row.weight.lumps) attach(lump.weight, p + R * lump.at);
    Vector3<S> member = Vector3<S>::Zero();
    if (k + 1 < chain.rows.size()) member = R * offsetInPreviousAxes<S>(chain.rows[k + 1]);
    using std::sqrt;
    if (valueOf(member.squaredNorm()) > 0)
      attach(row.weight.distributed * sqrt(member.squaredNorm()), p + member * S(0.5));
    attach(row.weight.end, p + member);
  }
  if (valueOf(weight) == 0) return {};
  return {weight, moment / weight};
}

/// Adds the weights of an arm's side chains to the rows of `to`, a copy of the arm.
template <class S>
void attachSideChains(const ArmOf<S>& arm, const PostureOf<S>& posture, ArmOf<S>& to) {
  if (arm.side_chains.empty()) return;
  Eigen::Matrix<S, Eigen::Dynamic, 1> q = posture.side_q;
  if (q.size() == 0) q = defaultSideReadings(arm).template cast<S>();
  Eigen::Index joint = 0;
  for (const SideChain<S>& chain : arm.side_chains) {
    auto& terms = to.rows[static_cast<std::size_t>(chain.row)].effect_terms;
    if (!terms) terms.emplace();
    terms->attached_weights.push_back(weightOfSideChain<S>(chain, q, joint));
  }
}

}  // namespace tubeplan::deflection
