#include "deflection/revolute_chain/revolute_chain.hpp"

#include <algorithm>
#include <cmath>

namespace tubeplan::deflection::simd {

using Eigen::Matrix3d, Eigen::Vector3d;

namespace {

constexpr double kSameFrame = 1e-15;  ///< rounding error of composed frames: of unit vectors, and of positions / reach

/// A compliance about a single axis.
struct OneAxis {
  Vector3d axis;
  double compliance;
};

std::optional<OneAxis> oneAxisOf(const Matrix3d& compliance) {
  int k = 0;
  compliance.diagonal().maxCoeff(&k);
  if (!(compliance(k, k) > 0)) return std::nullopt;
  const Vector3d axis = compliance.col(k).normalized();
  const double size = compliance.trace();
  if (!((compliance - size * axis * axis.transpose()).cwiseAbs().maxCoeff() <= 1e-14 * size)) return std::nullopt;
  return OneAxis{axis, size};
}

/// Returns right-handed axes with the given unit vector as z axis.
Matrix3d axesAbout(const Vector3d& z) {
  Vector3d::Index largest = 0;
  z.cwiseAbs().maxCoeff(&largest);
  Matrix3d R;
  if (z.cwiseAbs().sum() == 1) {
    // z is a coordinate axis, so exact axes are available.
    R.col(2) = z;
    R.col(0) = Vector3d::Unit((largest + 1) % 3);
  } else {
    R.col(2) = z;
    R.col(0) = Vector3d::Unit((largest + 1) % 3).cross(z).normalized();
  }
  R.col(1) = R.col(2).cross(R.col(0));
  return R;
}

/// A rotation as Rz(before) Rx(twist) Rz(after); `before` is 0 if there is no twist.
struct Twist {
  double before = 0, cosine = 1, sine = 0, after = 0;
};

/// Returns the sine of the angle between the z axes before and after the rotation R.
double sineOf(const Matrix3d& R) { return std::sqrt(R(0, 2) * R(0, 2) + R(1, 2) * R(1, 2)); }

Twist twistOf(const Matrix3d& R) {
  Twist out;
  const double sine = sineOf(R);
  if (sine < kSameFrame) {
    out.cosine = R(2, 2) > 0 ? 1 : -1;
    out.after = std::atan2(out.cosine * R(1, 0), R(0, 0));
    return out;
  }
  out.before = std::atan2(R(0, 2), -R(1, 2));
  const bool square = std::abs(R(2, 2)) < kSameFrame;
  out.cosine = square ? 0 : R(2, 2);
  out.sine = square ? 1 : sine;
  // The rotation that remains after the first two. For nearly parallel axes, rounding makes `before` and `after`
  // inaccurate, but not their combination.
  const double c = std::cos(out.before), s = std::sin(out.before);
  const Vector3d x(c * R(0, 0) + s * R(1, 0), c * R(1, 0) - s * R(0, 0), R(2, 0));
  out.after = std::atan2(out.cosine * x.y() + out.sine * x.z(), x.x());
  return out;
}

}  // namespace

/// Builder that walks the chain outwards. It keeps the last turn open for additions, and tracks the pose of the current
/// link in that turn's frame.
class RevoluteChain::Builder {
 public:
  Builder(double reach, std::size_t elements) : reach_(reach) {
    out_.turns_.reserve(elements + 8);
    out_.elements_.reserve(elements);
  }

  bool addElement(const ChainLink<double>& link, const FlexibleElement& element) {
    // Gaps, soft zones and compliances of zero are treated as absent.
    if ((element.hasGap() && !element.gap_width.isZero(0)) || !element.flexibility.softness.isZero(0)) return false;
    if (element.flexibility.compliance.isZero(0)) {
      addWeight(element.weight, link_pose_.p + link_pose_.R * (link.p / 2));
      link_pose_.p += link_pose_.R * link.p;
      out_.elements_.push_back({-1, Vector3d::UnitZ(), 0, false, link.p});
      return true;
    }
    const auto axis_compliance = oneAxisOf(element.flexibility.compliance);
    if (!axis_compliance) return false;
    const bool is_member = link.type == ChainLinkType::kMember;
    const Vector3d lever = axis_compliance->axis.cross(link.p);
    const bool is_beam = is_member && lever.norm() > 1e-12 * link.p.norm();
    if (is_beam && std::abs(axis_compliance->axis.dot(link.p)) > 1e-14 * link.p.norm()) return false;
    const Matrix3d axes = axesAbout(axis_compliance->axis);
    if (is_beam)
      addBeam(link, axes, axis_compliance->compliance, element.weight);
    else {
      if (is_member)
        addWeight(element.weight, link_pose_.p + link_pose_.R * (link.p / 2)), link_pose_.p += link_pose_.R * link.p;
      turnTo(axes).compliance += axis_compliance->compliance;
    }
    link_pose_.R = link_pose_.R * axes.transpose();
    out_.elements_.push_back({last(), axis_compliance->axis, axis_compliance->compliance, is_beam, link.p});
    return true;
  }

  void addLink(const ChainLink<double>& link, int joint, double offset) {
    if (link.type == ChainLinkType::kTurn) link_pose_.R = link_pose_.R * link.R;
    if (joint >= 0) {
      Turn& turn = turnTo(Matrix3d::Identity(), true);
      turn.joint = joint;
      turn.offset += offset;
    }
    const Vector3d p = link_pose_.R * link.p;
    const bool aside = link.type == ChainLinkType::kLump;
    addWeight(link.weight, link_pose_.p + (aside ? Vector3d(link_pose_.R * link.lever) : Vector3d(p / 2)));
    link_pose_.p += p;
  }

  void markAxis() { out_.last_axis_ = {last(), link_pose_.R.col(2)}; }
  void markRow(int row) { out_.rows_.push_back({row, last(), link_pose_}); }

  std::optional<RevoluteChain> finish(int joints) {
    if (last() < 0) return std::nullopt;
    const Twist tip = twistOf(link_pose_.R);
    if (tip.sine == 0 && tip.cosine > 0) turnFrame(tip.after);
    if (last() >= kMaxTurns) return std::nullopt;
    if (!rows_are_fixed_) out_.rows_.clear();
    RevoluteArm& numbers = out_.numbers_;
    const bool turned = !link_pose_.R.isIdentity(4 * kSameFrame);
    numbers = {nullptr, last() + 1, joints, reach_, {}, {}, turned, false};
    for (int k = 0; k < 9; ++k) numbers.tip_R[k] = link_pose_.R.data()[k];
    for (int k = 0; k < 3; ++k) numbers.tip_p[k] = link_pose_.p[k];
    int unknowns = 0;
    for (Turn& turn : out_.turns_) {
      complete(turn);
      unknowns += turn.is_compliant + turn.is_beam;
      numbers.is_compliant = numbers.is_compliant || turn.is_compliant;
    }
    out_.has_jacobian_ = unknowns <= kMaxUnknowns && joints <= kMaxJoints;
    return std::move(out_);
  }

 private:
  [[nodiscard]] int last() const { return static_cast<int>(out_.turns_.size()) - 1; }

  static void complete(Turn& turn) {
    if (turn.joint < 0) {
      turn.cos_rest = std::cos(turn.offset);
      turn.sin_rest = std::sin(turn.offset);
    }
    for (int k = 0; k < 3; ++k) turn.shifted[k] = turn.p[k] != 0;
    turn.twist = turn.sin_twist == 0 && turn.cos_twist == 1 ? kStraight : turn.cos_twist == 0 ? kQuarter : kOblique;
    turn.is_compliant = turn.compliance > 0;
    turn.has_moment = turn.moment[0] != 0 || turn.moment[1] != 0 || turn.moment[2] != 0;
  }

  void addWeight(double weight, const Vector3d& place) {
    if (last() < 0) return;  // the base carries the weight, so it does not load any turn
    Turn& turn = out_.turns_.back();
    turn.weight += weight;
    for (int k = 0; k < 3; ++k) turn.moment[k] += weight * place[k];
  }

  /// Rotates the last turn and its frame by a further angle.
  void turnFrame(double angle) {
    if (angle == 0) return;
    const Matrix3d back = rotationZ<double>(-angle);
    Turn& turn = out_.turns_.back();
    turn.offset += angle;
    Eigen::Map<Vector3d> moment(turn.moment);
    moment = (back * moment).eval();
    link_pose_ = {back * link_pose_.R, back * link_pose_.p};
    if (out_.last_axis_.turn == last()) out_.last_axis_.direction = back * out_.last_axis_.direction;
    for (RowOnTurn& row : out_.rows_)
      if (row.turn == last()) row.X_TL = PoseOf<double>{back, Vector3d::Zero()} * row.X_TL;
  }

  /// Returns true if a turn about the z axis of R at the current pose can be merged with the last turn.
  [[nodiscard]] bool isOneWithLast(const Matrix3d& R, bool with_joint) const {
    if (!startsAtLast(R)) return false;
    const Turn& turn = out_.turns_.back();
    const double load = turn.weight * reach_;
    return std::max({std::abs(turn.moment[0]), std::abs(turn.moment[1]), std::abs(turn.moment[2])}) <=
               kSameFrame * load &&
           !(with_joint && turn.joint >= 0);
  }

  /// Returns the turn about the z axis of `axes` (in the present axes) at the current position: the last turn, if
  /// possible, or a new one. The following links start from that turn.
  Turn& turnTo(const Matrix3d& axes, bool with_joint = false) {
    const Matrix3d R = link_pose_.R * axes;
    if (isOneWithLast(R, with_joint)) {
      // Rows already fixed to the last turn would wrongly rotate with this addition, so the chain cannot represent
      // their frames.
      for (const RowOnTurn& row : out_.rows_) rows_are_fixed_ = rows_are_fixed_ && row.turn != last();
      link_pose_.R = R;
      turnFrame(twistOf(R).after);
      for (double& m : out_.turns_.back().moment) m = 0;
      link_pose_ = {};
      return out_.turns_.back();
    }
    const Twist twist = twistOf(R);
    if (twist.before != 0 && last() < 0) {
      out_.turns_.push_back({});
      startTurn(out_.turns_.back());
    }
    link_pose_.R = R;
    turnFrame(twist.before);
    Turn turn{};
    startTurn(turn);
    for (int k = 0; k < 3; ++k) turn.p[k] = link_pose_.p[k];
    turn.cos_twist = twist.cosine;
    turn.sin_twist = twist.sine;
    turn.offset = twist.after;
    out_.turns_.push_back(turn);
    link_pose_ = {};
    return out_.turns_.back();
  }

  static void startTurn(Turn& turn) {
    turn.cos_twist = 1;
    turn.joint = -1;
  }

  void addBeam(const ChainLink<double>& link, const Matrix3d& axes, double compliance, double weight) {
    // The beam starts at its near end, from a frame whose z axis is the bending axis.
    const Vector3d v = axes.transpose() * link.p;
    const Matrix3d R = link_pose_.R * axes;
    if (startsAtLast(R)) {
      link_pose_.R = R;
      turnFrame(twistOf(R).after);
    } else {
      turnTo(axes);
    }
    Turn turn{};
    startTurn(turn);
    turn.p[0] = v.x();
    turn.p[1] = v.y();
    turn.is_beam = true;
    turn.compliance = turn.beam_compliance = compliance;
    turn.beam_weight = weight;
    out_.turns_.push_back(turn);
    link_pose_ = {};
  }

  /// Returns true if a beam can start at the last turn's frame, regardless of the weights that the turn carries.
  [[nodiscard]] bool startsAtLast(const Matrix3d& R) const {
    return last() >= 0 && R(2, 2) > 0 && sineOf(R) < kSameFrame &&
           link_pose_.p.cwiseAbs().maxCoeff() <= kSameFrame * reach_;
  }

  double reach_;
  RevoluteChain out_;
  PoseOf<double> link_pose_;  ///< pose of the current link in the last turn's frame, or in the base's
  bool rows_are_fixed_ = true;
};

std::optional<RevoluteChain> RevoluteChain::of(const Chain<double>& chain, const Arm& arm,
                                               const std::vector<int>& joint_of,
                                               const std::vector<FlexibleElement>& elements, double reach) {
  Builder builder(reach, elements.size());
  const std::vector<int> active = activeRows(arm);
  auto element = elements.begin();
  for (std::size_t k = 0; k < chain.links.size(); ++k) {
    const ChainLink<double>& link = chain.links[k];
    if (link.component >= 0) {
      if (!builder.addElement(link, *element++)) return std::nullopt;
      continue;
    }
    const double offset = arm.rows[static_cast<std::size_t>(link.row)].joint.offset;
    builder.addLink(link, joint_of[k], offset);
    if (link.type != ChainLinkType::kFrame) continue;
    builder.markRow(link.row);
    if (!active.empty() && link.row == active.back()) builder.markAxis();
  }
  return builder.finish(static_cast<int>(active.size()));
}

RevoluteArm RevoluteChain::numbers() const {
  RevoluteArm arm = numbers_;
  arm.turns = turns_.data();
  return arm;
}

void RevoluteChain::copyDeflections(const double* element_states, long stride,
                                    std::vector<FlexibleElement>& elements) const {
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const RevoluteElement& hinge = elements_[e];
    elements[e].deflection = {};
    elements[e].gap.setZero();
    elements[e].turn.setIdentity();
    if (hinge.turn < 0) continue;
    const double* of_turn = element_states + 4 * hinge.turn * stride;
    const double moment = of_turn[0], angle_of_all = of_turn[stride], lambda = of_turn[2 * stride],
                 kappa = of_turn[3 * stride];
    double angle = hinge.compliance * moment;
    Vector3d displacement = Vector3d::Zero();
    if (hinge.is_beam) {
      // The angle of this element is the total angle minus the angle of the other springs about the same axis.
      angle = angle_of_all - (turns_[static_cast<std::size_t>(hinge.turn)].compliance - hinge.compliance) * moment;
      displacement = lambda * hinge.axis.cross(hinge.member) - kappa * hinge.member;
    }
    elements[e].deflection = {displacement, angle * hinge.axis};
    elements[e].turn = rotationFromVector<double>(elements[e].deflection.rotation);
  }
}

}  // namespace tubeplan::deflection::simd
