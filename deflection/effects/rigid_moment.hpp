// The moments that an arm's weights and the hung load put on its rows, as if nothing gave: an explicit function of
// posture and numbers, for laws that read them.
#pragma once

#include "deflection/chain.hpp"
#include "deflection/parameters.hpp"

namespace tubeplan::deflection {

/// On each row: of everything from its frame outwards, about its origin, in its axes [N m].
template <class S>
std::vector<Vector3<S>> rigidMoments(const ArmOf<S>& arm, const PostureOf<S>& posture) {
  Chain<S> chain;
  if constexpr (std::is_same_v<S, double>)
    chain = assembleChain<double>(arm, arm, posture.q);
  else
    chain = assembleChain<S>(arm, castArm<double>(arm), posture.q);
  std::vector<PoseOf<S>> frames(chain.links.size() + 1);
  for (std::size_t k = 0; k < chain.links.size(); ++k) {
    const ChainLink<S>& link = chain.links[k];
    frames[k + 1].p = frames[k].p + frames[k].R * link.p;
    frames[k + 1].R = link.type == ChainLinkType::kTurn ? Matrix3<S>(frames[k].R * link.R) : frames[k].R;
  }
  std::vector<Vector3<S>> moments(arm.rows.size(), Vector3<S>::Zero());
  Vector3<S> force = posture.gravity_B * posture.load, moment = Vector3<S>::Zero();
  for (std::size_t k = chain.links.size(); k-- > 0;) {
    const ChainLink<S>& link = chain.links[k];
    if (link.type == ChainLinkType::kFrame)
      moments[static_cast<std::size_t>(link.row)] = frames[k].R.transpose() * moment;
    const Vector3<S> weight = posture.gravity_B * link.weight;
    const bool hangs_aside = link.type == ChainLinkType::kLump;
    const Vector3<S> chord = frames[k + 1].p - frames[k].p;
    const Vector3<S> lever = hangs_aside ? Vector3<S>(frames[k].R * link.lever) : Vector3<S>(chord * S(0.5));
    moment += chord.cross(force) + lever.cross(weight);
    force += weight;
  }
  return moments;
}

}  // namespace tubeplan::deflection
