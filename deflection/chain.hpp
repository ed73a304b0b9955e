// The arm at a posture, flattened into a sequence of links. A sweep outwards along the sequence gives positions, a
// sweep inwards gives loads.
#pragma once

#include <algorithm>
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
  kFlexJoint,  ///< flexible element at the row's origin
  kMember,     ///< section of the member, rigid or flexible, with its distributed weight
  kFrame,      ///< the row's frame, weightless
  kLump,       ///< point mass carried by the row
  kEndWeight,  ///< point mass at the member's end
};

/// One link of the flattened chain. The near frame of the link is the far frame of the link before.
template <class S>
struct ChainLink {
  ChainLinkType type;
  int row;
  int component = -1;                     ///< index of the link's element in Chain::components; -1 means rigid
  Vector3<S> p = Vector3<S>::Zero();      ///< translation to the far end, in near axes [m]
  Matrix3<S> R = Matrix3<S>::Identity();  ///< rotation of a kTurn link
  S weight{0};                            ///< weight of the member's section or of the point mass [N]
  Vector3<S> lever = Vector3<S>::Zero();  ///< vector from the link's near frame to the point mass, in near axes [m]
};

template <class S>
struct Chain {
  std::vector<ChainLink<S>> links;
  std::vector<ComponentState> components;
  int clearances = 0;  ///< number of axes with a clearance greater than zero
};

/// Returns R followed by a rotation by `beta` [rad] about the resulting y axis. In most rows, `beta` is zero.
template <class S>
Matrix3<S> leaned(const Matrix3<S>& R, const S& beta) {
  return isConstantZero(beta) ? R : Matrix3<S>(R * rotationY<S>(beta));
}

/// Returns the translation from the previous row's origin to this row's origin, in the previous row's axes [m]. For a
/// prismatic row, it ends at the bearing.
template <class S>
Vector3<S> offsetInPreviousAxes(const Row<S>& row) {
  const auto* dh = std::get_if<DenavitHartenberg<S>>(&row.placement);
  if (!dh) return std::get<Origin<S>>(row.placement).position;
  const Matrix3<S> turn = rotationX<S>(dh->alpha);
  const Vector3<S> offset =
      Vector3<S>::UnitX() * dh->a + leaned<S>(turn, dh->beta) * Vector3<S>(Vector3<S>::UnitZ() * dh->d);
  return isConstantZero(dh->b) ? offset : Vector3<S>(offset + turn * Vector3<S>(Vector3<S>::UnitY() * dh->b));
}

/// Returns the rotation of a row relative to the previous row, with its joint at zero; the joint rotates about the
/// resulting z axis.
template <class S>
Matrix3<S> rotationFromPrevious(const Row<S>& row) {
  if (const auto* dh = std::get_if<DenavitHartenberg<S>>(&row.placement))
    return leaned<S>(rotationX<S>(dh->alpha), dh->beta) * rotationZ<S>(dh->theta);
  const auto& origin = std::get<Origin<S>>(row.placement);
  return leaned<S>(rotationFromFixedAngles<S>(origin.rpy), origin.beta);
}

/// Returns the index of an active row's joint in joint vectors.
template <class S>
int jointIndexOf(const ArmOf<S>& arm, int row) {
  int index = 0;
  for (int i = 0; i < row; ++i) index += arm.rows[i].joint.type != JointType::kPassive;
  return index;
}

/// Returns the angle by which the driving joints rotate a row [rad], without the row's own offset.
template <class S>
S followedAngle(const ArmOf<S>& arm, const Joint<S>& joint, const Eigen::Matrix<S, Eigen::Dynamic, 1>& q) {
  S angle(0);
  for (const auto& followed : joint.follows)
    angle += S(followed.ratio) * (q[jointIndexOf(arm, followed.row)] + arm.rows[followed.row].joint.offset);
  return angle;
}

namespace chain_assembly {

/// Adds the flexible components of a row, at its origin or along its member, split into `pieces` sections. Adds none if
/// the row is rigid there. At most one law applies at the origin and one along the member.
template <class S>
void addElements(Chain<S>& chain, const Row<double>& values, int row, ElementPlace place, int pieces) {
  const auto kinds = elementKinds();
  for (int k = 0; k < static_cast<int>(kinds.size()); ++k) {
    if (kinds[k].place != place || !kinds[k].isFlexible(values)) continue;
    for (int s = 0; s < pieces; ++s) chain.components.push_back({.row = row, .kind = k, .segment = s});
    return;
  }
}

inline int segmentsOf(const Row<double>& values) {
  for (const auto& kind : elementKinds())
    if (kind.place == ElementPlace::kMember && kind.isFlexible(values)) return kind.segments(values);
  return 0;
}

template <class S>
void addJoint(Chain<S>& chain, const Row<double>& values, int row) {
  const auto before = chain.components.size();
  if (values.effect_terms) chain.clearances += static_cast<int>((values.effect_terms->gap.array() > 0).count());
  addElements<S>(chain, values, row, ElementPlace::kOrigin, 1);
  if (chain.components.size() == before) return;
  ChainLink<S> link{ChainLinkType::kFlexJoint, row};
  link.component = static_cast<int>(before);
  chain.links.push_back(link);
}

/// Returns the position of a point mass along a flexible member, as a fraction of the member's length; 0 for a point
/// mass at the row's origin or on a rigid member.
inline double shareOf(const Row<double>& values, int lump, const Vector3<double>& member) {
  if (segmentsOf(values) == 0 || member.squaredNorm() == 0) return 0;
  return std::clamp(values.weight.lumps[static_cast<std::size_t>(lump)].at.dot(member) / member.squaredNorm(), 0., 1.);
}

/// End of a section of the member, as a fraction of the member's length. `value` is a plain number that decides where
/// the member is cut; `share` is the same fraction with its derivatives.
template <class S>
struct Cut {
  double value;
  S share;
};

/// Adds the point masses at the fraction `share` of the member's length; `position` is the position of this point in
/// the row's axes.
template <class S>
void addLumps(Chain<S>& chain, const Row<S>& row, const Row<double>& values, int index, const Vector3<double>& member,
              double share, const Vector3<S>& position) {
  for (std::size_t k = 0; k < row.weight.lumps.size(); ++k) {
    if (shareOf(values, static_cast<int>(k), member) != share) continue;
    ChainLink<S> link{ChainLinkType::kLump, index};
    link.weight = row.weight.lumps[k].weight;
    link.lever = row.weight.lumps[k].at - position;
    chain.links.push_back(link);
  }
}

/// Returns the ends of the member's sections: the ends of its flexible segments and the positions of its point masses.
template <class S>
std::vector<Cut<S>> cutsOf(const Row<S>& row, const Row<double>& values, const Vector3<S>& v) {
  const Vector3<double> member = valuesOf(v);
  const int segments = std::max(1, segmentsOf(values));
  std::vector<Cut<S>> cuts;
  for (int s = 1; s <= segments; ++s) {
    const double share = static_cast<double>(s) / segments;
    cuts.push_back({share, S(share)});
  }
  for (std::size_t k = 0; k < values.weight.lumps.size(); ++k) {
    const double share = shareOf(values, static_cast<int>(k), member);
    if (share <= 0) continue;
    cuts.push_back({share, share < 1 ? S(row.weight.lumps[k].at.dot(v) / v.squaredNorm()) : S(1)});
  }
  std::stable_sort(cuts.begin(), cuts.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  const auto same = [](const Cut<S>& a, const Cut<S>& b) { return a.value == b.value; };
  cuts.erase(std::unique(cuts.begin(), cuts.end(), same), cuts.end());
  return cuts;
}

template <class S>
void addMember(Chain<S>& chain, const Row<S>& row, const Row<double>& values, int index, const Vector3<S>& v) {
  using std::sqrt;
  const Vector3<double> member = valuesOf(v);
  const int first = static_cast<int>(chain.components.size());
  const std::vector<Cut<S>> cuts = cutsOf<S>(row, values, v);
  addElements<S>(chain, values, index, ElementPlace::kMember, static_cast<int>(cuts.size()));
  const bool flexible = static_cast<int>(chain.components.size()) > first;
  const bool has_length = valueOf(v.squaredNorm()) > 0;
  S from(0);
  for (std::size_t s = 0; s < cuts.size(); ++s) {
    ChainLink<S> link{ChainLinkType::kMember, index};
    link.component = flexible ? first + static_cast<int>(s) : -1;
    link.p = v * S(cuts[s].share - from);
    if (has_length) link.weight = row.weight.distributed * sqrt(v.squaredNorm()) * S(cuts[s].share - from);
    chain.links.push_back(link);
    addLumps<S>(chain, row, values, index, member, cuts[s].value, v * cuts[s].share);
    from = cuts[s].share;
  }
  ChainLink<S> end{ChainLinkType::kEndWeight, index};
  end.weight = row.weight.end;
  chain.links.push_back(end);
}

/// Adds the weights that effects hang from the row's origin.
template <class S>
void addAttachedWeights(Chain<S>& chain, const Row<S>& row, int index) {
  if (!row.effect_terms) return;
  for (const Lump<S>& lump : row.effect_terms->attached_weights) {
    ChainLink<S> link{ChainLinkType::kLump, index};
    link.weight = lump.weight;
    link.lever = lump.at;
    chain.links.push_back(link);
  }
}

/// Adds a prismatic row: its bar, then its frame at the bar's end, with the point masses in that frame.
template <class S>
void addSlide(Chain<S>& chain, const Row<S>& row, const Row<double>& values, int index, const Vector3<S>& bar) {
  Row<S> bar_row = row;
  Row<double> bar_values = values;
  bar_row.weight.lumps.clear();
  bar_values.weight.lumps.clear();
  addMember<S>(chain, bar_row, bar_values, index, bar);
  chain.links.push_back({ChainLinkType::kFrame, index});
  addLumps<S>(chain, row, values, index, Vector3<double>::Zero(), 0, Vector3<S>::Zero());
  addAttachedWeights<S>(chain, row, index);
}

}  // namespace chain_assembly

/// Adds the links of one row. `values` is the row in plain numbers. The choice of links depends on these alone, so
/// every scalar type gives the same links. `reading` is the joint's value including its offset, or zero if the row does
/// not move. `to_next` is the vector to the next row's origin or the tip, from the row's origin or the end of a
/// prismatic row's bar.
template <class S>
void assembleRow(Chain<S>& chain, const Row<S>& row, const Row<double>& values, int index, const S& reading,
                 const Vector3<S>& to_next) {
  using namespace chain_assembly;
  if (index == 0) chain.links.push_back({ChainLinkType::kOffset, 0, -1, offsetInPreviousAxes<S>(row)});
  ChainLink<S>& turn = chain.links.emplace_back(ChainLink<S>{ChainLinkType::kTurn, index});
  turn.R = rotationFromPrevious<S>(row);
  if (turns(values.joint)) turn.R = turn.R * rotationZ<S>(reading);
  addJoint<S>(chain, values, index);
  if (row.joint.type == JointType::kPrismatic) {
    addSlide<S>(chain, row, values, index, Vector3<S>::UnitZ() * reading);
    chain.links.push_back({ChainLinkType::kOffset, index, -1, to_next});
  } else {
    chain.links.push_back({ChainLinkType::kFrame, index});
    addLumps<S>(chain, row, values, index, valuesOf(to_next), 0, Vector3<S>::Zero());
    addAttachedWeights<S>(chain, row, index);
    addMember<S>(chain, row, values, index, to_next);
  }
}

/// Returns the argument `to_next` of assembleRow() for a row of an arm.
template <class S>
Vector3<S> offsetToNext(const ArmOf<S>& arm, std::size_t row) {
  return row + 1 == arm.rows.size() ? arm.p_LT : offsetInPreviousAxes<S>(arm.rows[row + 1]);
}

/// Returns all links of an arm at a posture; `values` is the same arm in plain numbers.
template <class S>
Chain<S> assembleChain(const ArmOf<S>& arm, const Arm& values, const Eigen::Matrix<S, Eigen::Dynamic, 1>& q) {
  Chain<S> chain;
  chain.links.reserve(arm.rows.size() * 5);
  int joint = 0;
  for (std::size_t i = 0; i < arm.rows.size(); ++i) {
    const Row<S>& row = arm.rows[i];
    const bool active = row.joint.type != JointType::kPassive;
    assert(!active || joint < q.size());
    S reading(0);
    if (active) reading = q[joint++] + row.joint.offset;
    if (!row.joint.follows.empty()) reading = followedAngle<S>(arm, row.joint, q) + row.joint.offset;
    assembleRow<S>(chain, row, values.rows[i], static_cast<int>(i), reading, offsetToNext<S>(arm, i));
  }
  assert(joint == q.size());
  return chain;
}

}  // namespace tubeplan::deflection
