// The arm at a posture, flattened into links that are swept once outwards (positions) and once inwards (loads).
#pragma once

#include <cassert>
#include <vector>

#include "deflection/arm.hpp"
#include "deflection/elements/element.hpp"
#include "deflection/flexible_kinematics.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::deflection {

enum class ChainLinkType {
  kOffset,     ///< weightless rigid translation
  kTurn,       ///< rigid rotation into the row's axes
  kFlexJoint,  ///< an element at the row's origin
  kMember,     ///< a piece of the member, rigid or an element, with its distributed weight
  kFrame,      ///< the row's frame is here; its lumps hang from it
  kEndWeight,  ///< the weight at the member's end
};

/// One link of the flattened chain; its near frame is the far frame of the link before.
template <class S>
struct ChainLink {
  ChainLinkType type;
  int row;
  int component = -1;                     ///< index of its deflection, -1 where rigid
  Vector3<S> p = Vector3<S>::Zero();      ///< translation, in near axes
  Matrix3<S> R = Matrix3<S>::Identity();  ///< rotation, for kTurn
  S weight{0};                            ///< total weight of this piece
};

template <class S>
struct Chain {
  std::vector<ChainLink<S>> links;
  std::vector<ComponentStateOf<S>> components;
};

/// Translation from a row's origin to the next row's (its bearing, when that one slides), in the row's axes.
template <class S>
Vector3<S> offsetInPreviousAxes(const Row<S>& row) {
  if (const auto* dh = std::get_if<DenavitHartenberg<S>>(&row.placement))
    return Vector3<S>::UnitX() * dh->a + rotationX<S>(dh->alpha) * Vector3<S>(Vector3<S>::UnitZ() * dh->d);
  return std::get<Origin<S>>(row.placement).position;
}

/// Rotation of a row against the one before, its joint turned by `angle` [rad].
template <class S>
Matrix3<S> rotationFromPrevious(const Row<S>& row, const S& angle) {
  if (const auto* dh = std::get_if<DenavitHartenberg<S>>(&row.placement))
    return rotationX<S>(dh->alpha) * rotationZ<S>(S(dh->theta + angle));
  return rotationFromFixedAngles<S>(std::get<Origin<S>>(row.placement).rpy) * rotationZ<S>(angle);
}

namespace chain_assembly {

template <class S>
void addElements(Chain<S>& chain, const Row<double>& values, int row, ElementPlace place, int* segments) {
  const auto kinds = elementKinds();
  for (int k = 0; k < static_cast<int>(kinds.size()); ++k) {
    if (kinds[k].place != place || !kinds[k].isFlexible(values)) continue;
    const int n = kinds[k].segments(values);
    for (int s = 0; s < n; ++s) chain.components.push_back({row, k, s, Vector3<S>::Zero(), Vector3<S>::Zero()});
    if (segments) *segments = n;
    return;  // one law per place
  }
}

template <class S>
void addJoint(Chain<S>& chain, const Row<double>& values, int row) {
  const auto before = chain.components.size();
  addElements<S>(chain, values, row, ElementPlace::kOrigin, nullptr);
  if (chain.components.size() == before) return;
  ChainLink<S> link{ChainLinkType::kFlexJoint, row};
  link.component = static_cast<int>(before);
  chain.links.push_back(link);
}

template <class S>
void addMember(Chain<S>& chain, const Row<S>& row, const Row<double>& values, int index, const Vector3<S>& v) {
  using std::sqrt;
  const int first = static_cast<int>(chain.components.size());
  int segments = 1;
  addElements<S>(chain, values, index, ElementPlace::kMember, &segments);
  const bool flexible = static_cast<int>(chain.components.size()) > first;
  const bool has_length = valueOf(v.squaredNorm()) > 0;
  for (int s = 0; s < segments; ++s) {
    ChainLink<S> link{ChainLinkType::kMember, index};
    link.component = flexible ? first + s : -1;
    link.p = v / S(segments);
    if (has_length) link.weight = row.weight.distributed * sqrt(v.squaredNorm()) / S(segments);
    chain.links.push_back(link);
  }
  ChainLink<S> end{ChainLinkType::kEndWeight, index};
  end.weight = row.weight.end;
  chain.links.push_back(end);
}

}  // namespace chain_assembly

/// `values` is the arm in plain numbers: which axes give decides the structure, the same for every scalar.
template <class S>
Chain<S> assembleChain(const ArmOf<S>& arm, const Arm& values, const Eigen::Matrix<S, Eigen::Dynamic, 1>& q) {
  using namespace chain_assembly;
  Chain<S> chain;
  chain.links.reserve(arm.rows.size() * 5);
  int joint = 0;
  for (int i = 0; i < static_cast<int>(arm.rows.size()); ++i) {
    const Row<S>& row = arm.rows[i];
    const bool slides = row.joint.type == JointType::kPrismatic;
    const bool active = row.joint.type != JointType::kPassive;
    assert(!active || joint < q.size());
    const S reading = active ? S(q[joint++] + row.joint.offset) : S(0);
    if (i == 0) chain.links.push_back({ChainLinkType::kOffset, 0, -1, offsetInPreviousAxes<S>(row)});
    ChainLink<S> turn{ChainLinkType::kTurn, i};
    turn.R = rotationFromPrevious<S>(row, slides ? S(0) : reading);
    chain.links.push_back(turn);
    addJoint<S>(chain, values.rows[i], i);
    const bool last = i + 1 == static_cast<int>(arm.rows.size());
    const Vector3<S> to_next = last ? arm.p_LT : offsetInPreviousAxes<S>(arm.rows[i + 1]);
    if (slides) {
      addMember<S>(chain, row, values.rows[i], i, Vector3<S>::UnitZ() * reading);
      chain.links.push_back({ChainLinkType::kFrame, i});
      chain.links.push_back({ChainLinkType::kOffset, i, -1, to_next});
    } else {
      chain.links.push_back({ChainLinkType::kFrame, i});
      addMember<S>(chain, row, values.rows[i], i, to_next);
    }
  }
  assert(joint == q.size());
  return chain;
}

}  // namespace tubeplan::deflection
