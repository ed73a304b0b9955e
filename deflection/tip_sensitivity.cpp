#include "deflection/tip_sensitivity.hpp"

namespace tubeplan::deflection {

using Eigen::Matrix3d, Eigen::Vector3d;

namespace {

/// Returns the matrix M with M a = (a x r) x F: the derivative of the moment of a force F when its point of action r
/// rotates.
Matrix3d momentByTurn(const Vector3d& r, const Vector3d& force) {
  return r * force.transpose() - r.dot(force) * Matrix3d::Identity();
}

Matrix3d cross(const Vector3d& a) { return crossMatrix<double>(a); }

/// Returns the point of action of a link's weight, in the base frame.
Vector3d placeOfWeight(const ChainLink<double>& link, const PoseOf<double>& near, const PoseOf<double>& far) {
  if (link.type == ChainLinkType::kLump) return near.p + near.R * link.lever;
  return (near.p + far.p) / 2;
}

/// Returns the index in the chain of the kFrame link of a row.
std::size_t linkOfFrame(const Chain<double>& chain, int row) {
  for (std::size_t k = 0; k < chain.links.size(); ++k)
    if (chain.links[k].type == ChainLinkType::kFrame && chain.links[k].row == row) return k;
  return chain.links.size();
}

}  // namespace

const TipRows& TipSensitivity::carriedShift(std::size_t link) const {
  static const TipRows kShift = TipRows::Identity(), kNone = TipRows::Zero();
  return carries(link) ? kShift : kNone;
}

TipRows TipSensitivity::forceAt(std::size_t k, const Vector3d& p) const {
  return loads_[k].by_force + loads_[k].by_moment * cross(p);
}

TipRows TipSensitivity::shiftAt(std::size_t k) const {
  return carriedShift(k) - loads_[k].by_moment * cross(outboard_[k].force);
}

TipRows TipSensitivity::turnAt(std::size_t k, const Vector3d& p) const {
  return motion_[k] + loads_[k].by_moment * outboard_[k].by_turn + shiftAt(k) * cross(p);
}

void TipSensitivity::answerOf(const PreparedArm& arm, std::size_t k, std::size_t e) {
  const Equilibrium& shape = arm.equilibrium();
  const FlexibleElement& element = shape.elements[e];
  const Loading<double> load = shape.loadingOf(e);
  const DeflectionSlopes slopes = element.kind->slopesOf(element.flexibility, load);
  Answer& out = answers_[e];
  out.R = frames_[k].R;
  out.turn_B = out.R * leftJacobian(element.deflection.rotation);
  out.is_member = element.kind->place == ElementPlace::kMember;
  out.rotation_by_moment = slopes.rotation_by_moment;
  if (out.is_member) {
    // Accounts for the feedback between a displacement and the chord that it changes.
    out.displacement_itself = (Matrix3d::Identity() - slopes.displacement_by_chord).inverse();
    out.displacement_by_force = out.displacement_itself * slopes.displacement_by_force;
    out.displacement_by_moment = out.displacement_itself * slopes.displacement_by_moment;
    out.displacement_by_weight = out.displacement_itself * slopes.displacement_by_weight;
    out.rotation_by_displacement = slopes.rotation_by_chord * out.displacement_itself;
    out.rotation_by_force = slopes.rotation_by_force + slopes.rotation_by_chord * out.displacement_by_force;
    out.rotation_by_moment += slopes.rotation_by_chord * out.displacement_by_moment;
    out.rotation_by_weight = slopes.rotation_by_weight + slopes.rotation_by_chord * out.displacement_by_weight;
  }
  // Derivative, in near axes, of the moment of the loads beyond with respect to a rotation of the near end.
  const OutboardLoad& outboard = outboard_[k];
  const Matrix3d by_turn = outboard.by_turn - momentByTurn(frames_[k + 1].p, outboard.force);
  const Matrix3d moment_by_turn = out.R.transpose() * by_turn;
  out.moment_by_rotation = moment_by_turn * out.turn_B;
  const Matrix3d seen = moment_by_turn + cross(load.moment) * out.R.transpose();
  Matrix3d right = out.rotation_by_moment * seen;
  if (out.is_member)
    right +=
        (out.rotation_by_force * cross(load.force) + out.rotation_by_weight * cross(load.weight)) * out.R.transpose();
  Matrix3d own = Matrix3d::Identity() - out.rotation_by_moment * out.moment_by_rotation;
  out.is_compliant.setOnes();
  for (int axis = 0; axis < 3; ++axis) {
    elements_[e].gap_positions[axis] = {};
    if (!element.has_gap[axis]) continue;
    elements_[e].gap_positions[axis] = shape.gapPositionOf(e, axis, load.moment[axis]);
    if (elements_[e].gap_positions[axis].by_angle == 0) continue;
    // The joint hangs freely in its gap about this axis. The condition of zero moment replaces the element's law.
    out.is_compliant[axis] = 0;
    out.rotation_by_moment.row(axis) = Eigen::RowVector3d::Unit(axis);
    right.row(axis) = seen.row(axis);
    own.row(axis) = -out.moment_by_rotation.row(axis);
  }
  out.inverse = own.inverse();
  const Matrix3d rotation = out.inverse * right;
  out.turn_by_turn = out.turn_B * rotation;
  if (!out.is_member) return;
  out.shift_by_turn =
      out.R * (out.displacement_by_moment * (seen + out.moment_by_rotation * rotation) +
               (out.displacement_by_force * cross(load.force) + out.displacement_by_weight * cross(load.weight)) *
                   out.R.transpose());
}

void TipSensitivity::sweepInwards(const PreparedArm& arm) {
  const Arm& numbers = arm.effective();
  const Vector3d& g = arm.effectivePosture().gravity_B;
  const DeadLoad& load = arm.equilibrium().loads.front();
  const PoseOf<double>& tip = frames_.back();
  OutboardLoad outboard{load.at_tip * g, momentByTurn(load.at_tip * tip.p + tip.R * load.tip_moment, g)};
  if (numbers.tip_load) {
    outboard.force += numbers.tip_load->force;
    outboard.by_turn += momentByTurn(tip.p, numbers.tip_load->force);
  }
  TipRows motion = TipRows::Zero();
  std::size_t e = arm.equilibrium().elements.size();
  for (std::size_t k = arm.chain().links.size(); k-- > 0;) {
    const ChainLink<double>& link = arm.chain().links[k];
    if (k + 1 == answering_) motion << -cross(frame().p), Matrix3d::Identity();
    outboard_[k] = outboard;
    motion_[k] = motion;
    const Vector3d weight = link.weight * g;
    if (link.component >= 0) {
      answerOf(arm, k, --e);
      const Answer& answer = answers_[e];
      const Matrix3d& turn = answer.turn_by_turn;
      Matrix3d moved = cross(frames_[k + 1].p) * turn;
      if (answer.is_member) {
        moved += answer.shift_by_turn;
        outboard.by_turn -= cross(weight / 2) * answer.shift_by_turn;
      }
      outboard.by_turn += outboard_[k].by_turn * turn - cross(outboard.force) * moved;
      motion += motion_[k] * turn;
      if (carries(k)) motion.topRows<3>() += moved;
    }
    if (link.weight != 0) {
      outboard.by_turn += momentByTurn(placeOfWeight(link, frames_[k], frames_[k + 1]), weight);
      outboard.force += weight;
    }
    const auto& effect_terms = numbers.rows[static_cast<std::size_t>(link.row)].effect_terms;
    if (link.type != ChainLinkType::kEndWeight || !effect_terms) continue;
    outboard.by_turn += momentByTurn(frames_[k].p, effect_terms->end_force);
    outboard.force += effect_terms->end_force;
  }
}

/// Passes from the near to the far end of an element: adds the difference between the tip's responses to a load beyond
/// the element and to a load before it.
void TipSensitivity::passElement(const PreparedArm& arm, std::size_t k, std::size_t e, LoadAnswer& load) {
  const Answer& a = answers_[e];
  const OutboardLoad& outboard = outboard_[k];
  const Vector3d& p = frames_[k + 1].p;
  ElementSensitivity& out = elements_[e];
  const TipRows shift = carriedShift(k) - load.by_moment * cross(outboard.force);
  const TipRows turn = motion_[k] + load.by_moment * outboard.by_turn + shift * cross(p);
  TipRows rotation = turn * a.turn_B;
  if (!a.is_member) {
    rotation = (rotation * a.inverse).eval();
    out.rotation = rotation * a.is_compliant.asDiagonal();
    const TipRows moment = rotation * (a.rotation_by_moment * a.R.transpose());
    load.by_force -= moment * cross(p);
    load.by_moment += moment;
    return;
  }
  const Vector3d weight = arm.chain().links[k].weight * arm.effectivePosture().gravity_B;
  const TipRows displacement = (shift - load.by_moment * cross(weight / 2)) * a.R;
  rotation = ((rotation + displacement * (a.displacement_by_moment * a.moment_by_rotation)) * a.inverse).eval();
  const TipRows compliant_rotation = rotation * a.is_compliant.asDiagonal();
  out.rotation = compliant_rotation;
  out.displacement = compliant_rotation * a.rotation_by_displacement + displacement * a.displacement_itself;
  out.weight = (compliant_rotation * a.rotation_by_weight + displacement * a.displacement_by_weight) * a.R.transpose() +
               load.by_force + load.by_moment * cross((frames_[k].p + p) / 2);
  const TipRows moment = (rotation * a.rotation_by_moment + displacement * a.displacement_by_moment) * a.R.transpose();
  load.by_force +=
      (compliant_rotation * a.rotation_by_force + displacement * a.displacement_by_force) * a.R.transpose() -
      moment * cross(p);
  load.by_moment += moment;
}

void TipSensitivity::sweepOutwards(const PreparedArm& arm) {
  LoadAnswer load{TipRows::Zero(), TipRows::Zero()};
  std::size_t e = 0;
  for (std::size_t k = 0; k < arm.chain().links.size(); ++k) {
    if (arm.chain().links[k].component >= 0) passElement(arm, k, e++, load);
    loads_[k] = load;
  }
}

void TipSensitivity::addGravity(const PreparedArm& arm) {
  const std::size_t last = arm.chain().links.size() - 1;
  const DeadLoad& load = arm.equilibrium().loads.front();
  const PoseOf<double>& tip = frames_.back();
  gravity_ = load.at_tip * forceAt(last, tip.p) + momentAt(last) * cross(tip.R * load.tip_moment);
  std::size_t e = 0;
  for (std::size_t k = 0; k <= last; ++k) {
    const ChainLink<double>& link = arm.chain().links[k];
    if (link.weight == 0) {
      e += link.component >= 0;
      continue;
    }
    if (link.component >= 0)
      gravity_ += link.weight * elements_[e++].weight;
    else
      gravity_ += link.weight * forceAt(k, placeOfWeight(link, frames_[k], frames_[k + 1]));
  }
}

void TipSensitivity::linearize(const PreparedArm& arm, int row) {
  arm.linkFrames(false, frames_);
  answering_ = row == kTool ? arm.chain().links.size() : linkOfFrame(arm.chain(), row);
  const std::size_t links = arm.chain().links.size(), elements = arm.equilibrium().elements.size();
  outboard_.resize(links);
  motion_.resize(links);
  loads_.resize(links);
  answers_.resize(elements);
  elements_.resize(elements);
  sweepInwards(arm);
  sweepOutwards(arm);
  addGravity(arm);
}

}  // namespace tubeplan::deflection
