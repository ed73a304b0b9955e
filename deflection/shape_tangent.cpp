#include "deflection/shape_tangent.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "deflection/parameters.hpp"

namespace tubeplan::deflection {

using Eigen::Matrix3d, Eigen::Vector3d;

namespace {

VectorTangent tangentOf(const Vector3<Dual>& v) {
  VectorTangent out;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < kDualSize; ++k) out(i, k) = v[i].derivatives()[k];
  return out;
}

NumberTangent tangentOf(const Dual& x) { return Eigen::Map<const NumberTangent>(x.derivatives().data()); }

/// The rotation vector by which R turns, in the axes that R leads to: the vee of dR R^T.
VectorTangent spinOf(const Matrix3<Dual>& R) {
  VectorTangent out = VectorTangent::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out.row(i) += R((i + 1) % 3, j).value() * tangentOf(R((i + 2) % 3, j));
  return out;
}

VectorTangent cross(const Vector3d& a, const VectorTangent& b) {
  VectorTangent out;
  out.row(0) = a.y() * b.row(2) - a.z() * b.row(1);
  out.row(1) = a.z() * b.row(0) - a.x() * b.row(2);
  out.row(2) = a.x() * b.row(1) - a.y() * b.row(0);
  return out;
}

VectorTangent cross(const VectorTangent& a, const Vector3d& b) { return -cross(b, a); }

bool translates(ChainLinkType type) { return type == ChainLinkType::kOffset || type == ChainLinkType::kMember; }

Deflection<Dual> deflectDual(const ComponentState& component, const ArmOf<Dual>& arm, const Loading<Dual>& loading) {
  return elementKinds()[component.kind].deflectDual(arm.rows[component.row], loading);
}

}  // namespace

/// What a block of variables changes in the chain directly.
struct ShapeTangent::Direct {
  struct Link {
    VectorTangent p = VectorTangent::Zero(), turn = VectorTangent::Zero(), lever = VectorTangent::Zero();
    NumberTangent weight = NumberTangent::Zero();
  };
  struct Element {
    VectorTangent displacement, rotation, gap = VectorTangent::Zero();
  };
  std::vector<Link> links;
  std::vector<Element> elements;
  std::vector<VectorTangent> pulls;  ///< by row
  VectorTangent gravity, payload_offset = VectorTangent::Zero();
  NumberTangent load, contact_force = NumberTangent::Zero();
  FrameTangent base;
};

/// The tangents that are iterated.
struct ShapeTangent::State {
  struct Element {
    VectorTangent displacement = VectorTangent::Zero(), rotation = VectorTangent::Zero(), gap = VectorTangent::Zero();
  };
  std::vector<FrameTangent> frames;
  std::vector<Element> elements;
  VectorTangent force = VectorTangent::Zero(), moment = VectorTangent::Zero();  ///< carried inwards
};

ShapeTangent::ShapeTangent(const Arm& arm, const Posture& posture, const FlexibleKinematics& shape)
    : situation_(situationOf(arm, posture)),
      constant_arm_(castArm<Dual>(situation_.arm)),
      chain_(assembleChain<double>(situation_.arm, situation_.arm, situation_.posture.q)),
      reach_(reachOf(situation_.arm)),
      // Derivatives close in as fast as the shape did. What still moves after twice as many passes is the rounding of a
      // derivative that is zero, which never rests relative to itself.
      enough_(2 * shape.iterations + 10),
      carried_(chain_.links.size()),
      elements_(chain_.components.size()) {
  assert(chain_.components.size() == shape.components.size());
  chain_.components = shape.components;
  combineTransforms(chain_, false, frames_);
  InwardSweep sweep = beginAtTip(situation_.arm, situation_.posture, reach_, chain_.clearances, frames_.back());
  std::vector<ComponentState> unused = chain_.components;
  for (std::size_t k = chain_.links.size(); k-- > 0;) {
    const ChainLink<double>& link = chain_.links[k];
    carried_[k] = {frames_[k + 1].p - frames_[k].p, situation_.posture.gravity_B * link.weight, sweep.carry.force,
                   sweep.carry.moment};
    if (link.component >= 0) elements_[link.component] = elementOf(sweep, k);
    resolveLink(sweep, frames_[k], frames_[k + 1], link, unused);
  }
}

ShapeTangent::Element ShapeTangent::elementOf(const InwardSweep& sweep, std::size_t k) const {
  const ChainLink<double>& link = chain_.links[k];
  const ComponentState& component = chain_.components[link.component];
  const Loading<double> loading = loadingOf(sweep, frames_[k], frames_[k + 1], link);
  Element element{{loading.force.cast<Dual>(), loading.moment.cast<Dual>(), loading.weight.cast<Dual>(),
                   loading.member.cast<Dual>(), loading.chord.cast<Dual>()},
                  {},
                  frames_[k].R * leftJacobian(component.rotation),
                  {}};
  for (int first = 0; first < 12; first += kDualSize) {
    Loading<Dual> seeded = element.loading;
    Vector3<Dual>* inputs[] = {&seeded.force, &seeded.moment, &seeded.weight, &seeded.chord};
    const int count = std::min(kDualSize, 12 - first);
    for (int s = 0; s < count; ++s) (*inputs[(first + s) / 3])[(first + s) % 3].derivatives()[s] = 1;
    const Deflection<Dual> by = deflectDual(component, constant_arm_, seeded);
    element.slope.topRows<3>().middleCols(first, count) = tangentOf(by.displacement).leftCols(count);
    element.slope.bottomRows<3>().middleCols(first, count) = tangentOf(by.rotation).leftCols(count);
  }
  const auto& addition = situation_.arm.rows[link.row].addition;
  for (int axis = 0; axis < 3 && addition && link.type == ChainLinkType::kFlexJoint; ++axis)
    if (addition->has_gap[axis])
      element.rests[axis] = restOf(sweep, link, axis, frames_[k], component.gap[axis], loading.moment[axis]);
  return element;
}

ShapeTangent::Direct ShapeTangent::directly(const ArmOf<Dual>& arm, const PostureOf<Dual>& posture) const {
  const Situation<Dual> situation = situationOf(arm, posture);
  const Chain<Dual> chain = assembleChain<Dual>(situation.arm, situation_.arm, situation.posture.q);
  Direct direct;
  direct.links.resize(chain.links.size());
  direct.elements.resize(chain.components.size());
  for (std::size_t k = 0; k < chain.links.size(); ++k) {
    const ChainLink<Dual>& link = chain.links[k];
    auto& out = direct.links[k];
    out.weight = tangentOf(link.weight);
    if (translates(link.type)) out.p = tangentOf(link.p);
    if (link.type == ChainLinkType::kTurn) out.turn = spinOf(link.R);
    if (link.type == ChainLinkType::kLump) out.lever = tangentOf(link.lever);
    if (link.component < 0) continue;
    Loading<Dual> loading = elements_[link.component].loading;
    loading.member = link.p;
    const Deflection<Dual> by = deflectDual(chain.components[link.component], situation.arm, loading);
    direct.elements[link.component].displacement = tangentOf(by.displacement);
    direct.elements[link.component].rotation = tangentOf(by.rotation);
    const auto& addition = situation.arm.rows[link.row].addition;
    if (addition) direct.elements[link.component].gap = tangentOf(addition->gap);
  }
  for (const auto& row : situation.arm.rows)
    direct.pulls.push_back(row.addition ? tangentOf(row.addition->pull) : VectorTangent::Zero());
  direct.gravity = tangentOf(situation.posture.gravity_B);
  direct.load = tangentOf(situation.posture.load);
  if (situation.arm.tip_load) {
    direct.payload_offset = tangentOf(situation.arm.tip_load->payload_offset);
    direct.contact_force = tangentOf(situation.arm.tip_load->contact_force);
  }
  direct.base = {tangentOf(situation.X_BM.p), spinOf(situation.X_BM.R)};
  return direct;
}

void ShapeTangent::moveFrames(const Direct& direct, State& state) const {
  for (std::size_t k = 0; k < chain_.links.size(); ++k) {
    const ChainLink<double>& link = chain_.links[k];
    const Matrix3d& R = frames_[k].R;
    const FrameTangent& near = state.frames[k];
    FrameTangent far = near;
    if (translates(link.type)) far.position += cross(near.rotation, carried_[k].chord) + R * direct.links[k].p;
    if (link.type == ChainLinkType::kTurn) far.rotation += R * direct.links[k].turn;
    if (link.component >= 0) {
      const auto& element = state.elements[link.component];
      far.position += R * element.displacement;
      far.rotation += elements_[link.component].turn_B * element.rotation;
    }
    state.frames[k + 1] = far;
  }
}

void ShapeTangent::deflectElement(std::size_t k, const Direct& direct, const VectorTangent& chord,
                                  const VectorTangent& weight, State& state) const {
  const ChainLink<double>& link = chain_.links[k];
  const Element& element = elements_[link.component];
  const Carried& at = carried_[k];
  const VectorTangent& turn = state.frames[k].rotation;
  const Matrix3d R_NB = frames_[k].R.transpose();
  // A vector seen from axes that turn: d(R^T a) = R^T (da - turn x a).
  const auto seen = [&](const VectorTangent& da, const Vector3d& a) -> VectorTangent {
    return R_NB * (da - cross(turn, a));
  };
  Eigen::Matrix<double, 12, kDualSize, Eigen::RowMajor> inputs;
  inputs << seen(state.force, at.force), seen(state.moment, at.moment), seen(weight, at.weight), seen(chord, at.chord);
  const auto& directly_by = direct.elements[link.component];
  auto& out = state.elements[link.component];
  out.displacement = element.slope.topRows<3>().lazyProduct(inputs) + directly_by.displacement;
  out.rotation = element.slope.bottomRows<3>().lazyProduct(inputs) + directly_by.rotation;
  for (int axis = 0; axis < 3; ++axis) {
    const clearance::Rest& rest = element.rests[axis];
    out.gap.row(axis) = rest.by_gap * directly_by.gap.row(axis) + rest.by_angle * out.gap.row(axis) +
                        rest.by_moment * inputs.row(3 + axis);
  }
  out.rotation += out.gap;
}

void ShapeTangent::moveLoads(const Direct& direct, State& state) const {
  const Vector3d& g = situation_.posture.gravity_B;
  const double load = situation_.posture.load;
  state.force = direct.gravity * load + g * direct.load;
  state.moment.setZero();
  if (const auto& tip = situation_.arm.tip_load) {
    const Vector3d lever = frames_.back().R * tip->payload_offset;
    const VectorTangent d_lever = cross(state.frames.back().rotation, lever) + frames_.back().R * direct.payload_offset;
    state.moment = cross(d_lever, g * load) + cross(lever, state.force);
    state.force -= direct.gravity * tip->contact_force + g * direct.contact_force;
  }
  for (std::size_t k = chain_.links.size(); k-- > 0;) {
    const ChainLink<double>& link = chain_.links[k];
    const Carried& at = carried_[k];
    const VectorTangent chord = state.frames[k + 1].position - state.frames[k].position;
    const VectorTangent weight = direct.gravity * link.weight + g * direct.links[k].weight;
    if (link.component >= 0) deflectElement(k, direct, chord, weight, state);
    if (translates(link.type))
      state.moment += cross(chord, at.force + at.weight / 2) + cross(at.chord, state.force + weight / 2);
    state.force += weight;
    if (link.type == ChainLinkType::kLump) {
      const Vector3d lever = frames_[k].R * link.lever;
      const VectorTangent d_lever = cross(state.frames[k].rotation, lever) + frames_[k].R * direct.links[k].lever;
      state.moment += cross(d_lever, at.weight) + cross(lever, weight);
    }
    if (link.type == ChainLinkType::kEndWeight) state.force += direct.pulls[link.row];
  }
}

FrameTangent ShapeTangent::tipInBase(const Direct& direct, const State& state) const {
  const Matrix3d& R = situation_.X_BM.R;
  const FrameTangent& tip = state.frames.back();
  FrameTangent out = direct.base;
  out.position += cross(direct.base.rotation, R * frames_.back().p) + R * tip.position;
  out.rotation += R * tip.rotation;
  return out;
}

namespace {

/// Largest relative change of a column between two passes.
double changeOf(const FrameTangent& now, const FrameTangent& before, double reach) {
  double change = 0;
  for (int k = 0; k < kDualSize; ++k) {
    const double size = std::max(now.position.col(k).norm(), reach * now.rotation.col(k).norm());
    const double step = std::max((now.position - before.position).col(k).norm(),
                                 reach * (now.rotation - before.rotation).col(k).norm());
    if (!std::isfinite(step)) return step;
    if (size > 0) change = std::max(change, step / size);
  }
  return change;
}

}  // namespace

TipTangent ShapeTangent::along(const ArmOf<Dual>& arm, const PostureOf<Dual>& posture,
                               const FlexibleKinematicsOptions& options) const {
  const Direct direct = directly(arm, posture);
  State state;
  state.frames.resize(frames_.size());
  state.elements.resize(elements_.size());
  moveFrames(direct, state);
  TipTangent result;
  result.status = KinematicsStatus::kNotConverged;
  // Asking more of a derivative than its rounding never ends.
  const double tolerance = std::max(options.tolerance, 1e-13);
  for (result.iterations = 1; result.iterations <= options.max_iterations; ++result.iterations) {
    const FrameTangent before = state.frames.back();
    moveLoads(direct, state);
    moveFrames(direct, state);
    const double change = changeOf(state.frames.back(), before, reach_);
    if (!std::isfinite(change)) break;
    if (change > tolerance && result.iterations < enough_) continue;
    result.status = KinematicsStatus::kConverged;
    break;
  }
  result.tip = tipInBase(direct, state);
  return result;
}

}  // namespace tubeplan::deflection
