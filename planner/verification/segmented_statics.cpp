#include "planner/verification/segmented_statics.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "deflection/effects/effect_context.hpp"

namespace tubeplan::planner {

namespace {

using deflection::JointType;
using Eigen::AngleAxisd, Eigen::Matrix3d, Eigen::Vector3d;
using Row = deflection::Row<double>;

/// One step outwards along the arm: a rotation, a spring, a translation along a rigid segment that has weight, and the
/// loads at the end of the segment.
struct Step {
  Matrix3d turn = Matrix3d::Identity();
  /// Compliance of the spring after the rotation, in the axes of the spring [rad/(N m)].
  Matrix3d compliance = Matrix3d::Zero();
  Vector3d softness = Vector3d::Zero(), knee = Vector3d::Zero();
  Vector3d way = Vector3d::Zero();
  double weight = 0;                        ///< weight distributed along the translation [N]
  double end_weight = 0;                    ///< weight at the end of the step [N]
  Vector3d end_moment = Vector3d::Zero();   ///< first moment of eccentric loads at the end of the step [N m]
  Vector3d end_force_B = Vector3d::Zero();  ///< force at the end of the step, in base axes [N]
  Vector3d bent = Vector3d::Zero();         ///< rotation of the spring, as a rotation vector [rad]

  [[nodiscard]] bool isRigid() const { return compliance.isZero(0) && softness.isZero(0); }
};

Matrix3d turned(const Vector3d& by) {
  const double angle = by.norm();
  return angle > 0 ? AngleAxisd(angle, by / angle).toRotationMatrix() : Matrix3d::Identity();
}

/// Placement of a row by the four Denavit-Hartenberg steps in Craig's form with Hayati's beta, or by a URDF origin.
struct Placement {
  Vector3d way;
  Matrix3d turn;
};
Placement placementOf(const Row& row) {
  if (const auto* dh = std::get_if<deflection::DenavitHartenberg<double>>(&row.placement)) {
    const AngleAxisd twist(dh->alpha, Vector3d::UnitX());
    const Matrix3d to_axis = (twist * AngleAxisd(dh->beta, Vector3d::UnitY())).toRotationMatrix();
    return {Vector3d(dh->a, 0, 0) + twist * Vector3d(0, dh->b, 0) + to_axis * Vector3d(0, 0, dh->d),
            to_axis * AngleAxisd(dh->theta, Vector3d::UnitZ()).toRotationMatrix()};
  }
  const auto& origin = std::get<deflection::Origin<double>>(row.placement);
  return {origin.position,
          (AngleAxisd(origin.rpy.z(), Vector3d::UnitZ()) * AngleAxisd(origin.rpy.y(), Vector3d::UnitY()) *
           AngleAxisd(origin.rpy.x(), Vector3d::UnitX()) * AngleAxisd(origin.beta, Vector3d::UnitY()))
              .toRotationMatrix()};
}

/// Returns the curvature per moment [1/(N m^2)] of a member along the unit vector e.
Matrix3d curvatureOf(const Row& row, const Vector3d& e) {
  Matrix3d curvature = Matrix3d::Zero();
  const auto addAbout = [&](int axis, double compliance) {
    const Vector3d n = (Vector3d::Unit(axis) - e * e[axis]).normalized();
    curvature += compliance * n * n.transpose();
  };
  if (row.beam)
    for (int axis = 0; axis < 3; ++axis)
      if (std::isfinite(row.beam->E * row.beam->I[axis])) addAbout(axis, 1 / (row.beam->E * row.beam->I[axis]));
  if (row.beam && std::isfinite(row.beam->G * row.beam->J))
    curvature += e * e.transpose() / (row.beam->G * row.beam->J);
  if (!row.effect_terms || !row.effect_terms->member_is_compliant) return curvature;
  curvature += row.effect_terms->torsion_compliance * e * e.transpose();
  for (int axis = 0; axis < 3; ++axis)
    if (row.effect_terms->bends[static_cast<std::size_t>(axis)])
      addAbout(axis, row.effect_terms->bending_compliance[axis]);
  return curvature;
}

class SegmentedArm {
 public:
  SegmentedArm(const deflection::Arm& arm, const deflection::Posture& posture, int pieces)
      : arm_(arm), posture_(posture), pieces_(pieces) {
    Eigen::Index joint = 0;
    for (std::size_t k = 0; k < arm.rows.size(); ++k) {
      const Row& row = arm.rows[k];
      double angle = 0;
      if (row.joint.type != JointType::kPassive) angle = posture.q[joint++] + row.joint.offset;
      addRow(k, row.joint.follows.empty() ? angle : followed(row.joint));
    }
  }

  /// Iterates once: places all steps, then turns each spring. Returns the largest change of a spring's rotation [rad].
  double pass() {
    place();
    const Vector3d& g = posture_.gravity_B;
    const auto tip = arm_.tip_load.value_or(deflection::TipLoad<double>{});
    Vector3d force = (posture_.load - tip.contact_force) * g + tip.force;
    // The moment is about the tip; each step inwards then moves its reference point.
    Vector3d moment = posture_.load * (frames_.back() * tip.payload_offset).cross(g) + tip.moment;
    double change = 0;
    for (std::size_t k = steps_.size(); k-- > 0;) {
      Step& step = steps_[k];
      const Matrix3d& R = frames_[k];
      force += step.end_weight * g + step.end_force_B;
      moment += (R * step.end_moment).cross(g);
      const Vector3d way = R * step.way;
      moment += way.cross(force) + (way / 2).cross(step.weight * g);
      force += step.weight * g;
      change = std::max(change, bend(step, step.isRigid() ? Vector3d::Zero() : springMoment(k, moment)));
    }
    return change;
  }

  /// Returns the tip position for the current rotations of the springs [m].
  Vector3d tip() {
    place();
    return tip_;
  }

 private:
  double followed(const deflection::Joint<double>& joint) const {
    double angle = joint.offset;
    for (const auto& term : joint.follows) {
      Eigen::Index index = 0;
      for (int row = 0; row < term.row; ++row)
        index += arm_.rows[static_cast<std::size_t>(row)].joint.type != JointType::kPassive;
      angle += term.ratio * (posture_.q[index] + arm_.rows[static_cast<std::size_t>(term.row)].joint.offset);
    }
    return angle;
  }

  void addRow(std::size_t k, double angle) {
    const Row& row = arm_.rows[k];
    const Placement placement = placementOf(row);
    if (k == 0) steps_.emplace_back().way = placement.way;
    Step& step = steps_.emplace_back();
    step.turn = placement.turn;
    const bool slides = row.joint.type == JointType::kPrismatic;
    if (!slides) step.turn = step.turn * AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
    addSpring(row, step);
    const Vector3d to_next = k + 1 < arm_.rows.size() ? placementOf(arm_.rows[k + 1]).way : arm_.p_LT;
    if (slides) addMember(row, Vector3d(0, 0, angle));
    addLumps(row, slides ? Vector3d::Zero() : to_next);
    if (slides)
      steps_.emplace_back().way = to_next;
    else
      addMember(row, to_next);
  }

  static void addSpring(const Row& row, Step& step) {
    for (int axis = 0; axis < 3; ++axis) {
      if (std::isfinite(row.joint_stiffness[axis])) step.compliance(axis, axis) = 1 / row.joint_stiffness[axis];
      if (!row.effect_terms || !row.effect_terms->joint_is_compliant) continue;
      step.softness[axis] =
          row.effect_terms->softness[axis] / row.joint_stiffness[axis] + row.effect_terms->soft_compliance[axis];
      step.knee[axis] = row.effect_terms->knee[axis];
      step.compliance(axis, axis) += row.effect_terms->compliance[axis];
    }
  }

  /// Adds the lumped weights of a row. The weights of a rigid row act on its frame; a weight along a flexible member
  /// acts on the nearest piece.
  void addLumps(const Row& row, const Vector3d& member) {
    const bool gives = member.squaredNorm() > 0 && !curvatureOf(row, member.normalized()).isZero(0);
    Step& frame = steps_.emplace_back();
    const auto attach = [&](const deflection::Lump<double>& lump) {
      frame.end_weight += lump.weight;
      frame.end_moment += lump.weight * lump.at;
    };
    if (row.effect_terms)
      std::for_each(row.effect_terms->attached_weights.begin(), row.effect_terms->attached_weights.end(), attach);
    for (const auto& lump : row.weight.lumps) {
      const double share = gives ? std::clamp(lump.at.dot(member) / member.squaredNorm(), 0., 1.) : 0;
      if (share > 0) {
        pending_.push_back({share, lump});
        continue;
      }
      attach(lump);
    }
  }

  void addMember(const Row& row, const Vector3d& member) {
    const double length = member.norm();
    const Matrix3d curvature = length > 0 ? curvatureOf(row, member / length) : Matrix3d::Zero();
    const int pieces = curvature.isZero(0) ? 1 : pieces_;
    const Vector3d piece = member / pieces;
    for (int k = 0; k < pieces; ++k) {
      const double weight = row.weight.distributed * length / pieces;
      if (pieces > 1) addWay(piece / 2, weight / 2);
      if (pieces > 1) steps_.emplace_back().compliance = curvature * (length / pieces);
      addWay(pieces > 1 ? Vector3d(piece / 2) : piece, pieces > 1 ? weight / 2 : weight);
      for (const auto& [share, lump] : pending_) {
        if (std::min(static_cast<int>(share * pieces), pieces - 1) != k) continue;
        steps_.back().end_weight += lump.weight;
        steps_.back().end_moment += lump.weight * (lump.at - piece * (k + 1));
      }
    }
    pending_.clear();
    steps_.back().end_weight += row.weight.end;
    if (row.effect_terms) steps_.back().end_force_B += row.effect_terms->end_force;
  }

  void addWay(const Vector3d& way, double weight) {
    Step& step = steps_.emplace_back();
    step.way = way;
    step.weight = weight;
  }

  void place() {
    frames_.resize(steps_.size());
    Matrix3d R = Matrix3d::Identity();
    tip_.setZero();
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      R = R * steps_[k].turn * turned(steps_[k].bent);
      frames_[k] = R;
      tip_ += R * steps_[k].way;
    }
  }

  /// Returns the moment in the axes of the spring's fixed side, before the spring's rotation.
  [[nodiscard]] Vector3d springMoment(std::size_t k, const Vector3d& moment_B) const {
    return turned(steps_[k].bent) * (frames_[k].transpose() * moment_B);
  }

  static double bend(Step& step, const Vector3d& moment) {
    Vector3d bent = step.compliance * moment;
    for (int axis = 0; axis < 3; ++axis)
      bent[axis] += step.softness[axis] * std::clamp(moment[axis], -step.knee[axis], step.knee[axis]);
    const double change = (bent - step.bent).lpNorm<Eigen::Infinity>();
    step.bent = bent;
    return change;
  }

  const deflection::Arm& arm_;
  const deflection::Posture& posture_;
  int pieces_;
  std::vector<Step> steps_;
  /// Lumped weights along the next member, with their positions as a fraction of its length.
  std::vector<std::pair<double, deflection::Lump<double>>> pending_;
  std::vector<Matrix3d> frames_;  ///< orientation of each step, after the rotation of its spring
  Vector3d tip_;
};

}  // namespace

SegmentedStatics solveSegmentedStatics(const deflection::Arm& arm, const deflection::Posture& posture,
                                       const SegmentedStaticsOptions& options) {
  SegmentedStatics result;
  const auto context = deflection::contextOf(arm, posture);
  const auto has_gap = [](const Row& row) { return row.effect_terms && (row.effect_terms->gap.array() > 0).any(); };
  if (!context.undefined.empty() || std::any_of(context.arm.rows.begin(), context.arm.rows.end(), has_gap)) {
    result.status = SegmentedStaticsStatus::kNotCovered;
    result.reason = context.undefined.empty() ? "the arm has clearances" : context.undefined;
    return result;
  }
  SegmentedArm segmented(context.arm, context.posture, options.pieces);
  result.status = SegmentedStaticsStatus::kNotConverged;
  result.reason = "the segmented shape does not converge: the arm is too compliant for its load";
  for (int pass = 0; pass < options.max_passes; ++pass) {
    const double change = segmented.pass();
    if (!std::isfinite(change)) return result;
    if (change > options.tolerance) continue;
    result.status = SegmentedStaticsStatus::kConverged;
    result.reason.clear();
    result.p_BD = context.X_BM.p + context.X_BM.R * segmented.tip();
    return result;
  }
  return result;
}

}  // namespace tubeplan::planner
