// Moments on the rows of the undeflected arm due to its weights and the loads on its tip: for laws that depend on
// moments. They are an explicit function of posture and parameters, without iteration.
#pragma once

#include "deflection/parameters.hpp"
#include "deflection/side_chains.hpp"

namespace tubeplan::deflection {

/// Adds a wrench, rotated from base axes to the axes of the tip, to a force and a moment.
template <class S>
void addWrench(const Chain<S>& chain, const WrenchOf<S>& wrench, Vector3<S>& force, Vector3<S>& moment) {
  Matrix3<S> R = Matrix3<S>::Identity();
  for (const auto& link : chain.links)
    if (link.type == ChainLinkType::kTurn) R = (R * link.R).eval();
  force += R.transpose() * wrench.force_B;
  moment += R.transpose() * wrench.moment_B;
}

/// Returns, for each row, the moment about its origin of all loads outboard of its frame, in its axes [N m].
template <class S>
std::vector<Vector3<S>> rigidMoments(const ArmOf<S>& arm, const PostureOf<S>& posture) {
  ArmOf<S> arm_with_side_chains;
  if (!arm.side_chains.empty()) {
    arm_with_side_chains = arm;
    attachSideChains<S>(arm, posture, arm_with_side_chains);
  }
  const ArmOf<S>& full_arm = arm.side_chains.empty() ? arm : arm_with_side_chains;
  Chain<S> chain;
  if constexpr (std::is_same_v<S, double>)
    chain = assembleChain<double>(full_arm, full_arm, posture.q);
  else
    chain = assembleChain<S>(full_arm, castArm<double>(full_arm), posture.q);
  const std::size_t count = chain.links.size();
  std::vector<Vector3<S>> gravity(count);  // direction of gravity in the near axes of each link
  Vector3<S> along = posture.gravity_B;
  for (std::size_t k = 0; k < count; ++k) {
    gravity[k] = along;
    if (chain.links[k].type == ChainLinkType::kTurn) along = (chain.links[k].R.transpose() * along).eval();
  }
  std::vector<Vector3<S>> moments(arm.rows.size(), Vector3<S>::Zero());
  // Loads beyond link k, in the axes of the link's far end and about that end.
  Vector3<S> force = along * posture.load, moment = Vector3<S>::Zero();
  if (posture.wrench) addWrench(chain, *posture.wrench, force, moment);
  for (std::size_t k = count; k-- > 0;) {
    const ChainLink<S>& link = chain.links[k];
    if (link.type == ChainLinkType::kFrame) moments[static_cast<std::size_t>(link.row)] = moment;
    if (link.type == ChainLinkType::kTurn) {
      force = (link.R * force).eval();
      moment = (link.R * moment).eval();
    }
    const Vector3<S> weight = gravity[k] * link.weight;
    if (link.type == ChainLinkType::kLump) moment += link.lever.cross(weight);
    // A distributed weight acts at the middle of the link.
    else
      moment += link.p.cross(force + weight * S(0.5));
    force += weight;
  }
  return moments;
}

}  // namespace tubeplan::deflection
