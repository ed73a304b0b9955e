#include "deflection/prepared_arm.hpp"

#include <cmath>

#include "deflection/revolute_chain/revolute_variables.hpp"

namespace tubeplan::deflection {

using Eigen::Vector3d, Eigen::VectorXd;

namespace {

bool hasSlide(const Arm& arm) {
  for (const auto& row : arm.rows)
    if (row.joint.type == JointType::kPrismatic) return true;
  return false;
}

/// Returns the readings at which the angle of every revolute joint is zero.
VectorXd turnsUndone(const Arm& arm, VectorXd q) {
  Eigen::Index joint = 0;
  for (const auto& row : arm.rows) {
    if (row.joint.type == JointType::kRevolute) q[joint] = -row.joint.offset;
    joint += row.joint.type != JointType::kPassive;
  }
  return q;
}

/// Replaces R with R Rz(angle): a rotation about the joint's axis z.
void turnAboutZ(double angle, Eigen::Matrix3d& R) {
  const double c = std::cos(angle), s = std::sin(angle);
  const Vector3d x = R.col(0);
  R.col(0) = c * x + s * R.col(1);
  R.col(1) = c * R.col(1) - s * x;
}

/// Returns the only axis about which an element rotates, if its law is linear; else -1.
int hingeOf(const FlexibleElement& element) {
  if (element.kind->place != ElementPlace::kOrigin || element.flexibility.has_soft_zone || element.hasGap()) return -1;
  const Vector3d compliance = element.flexibility.compliance.diagonal();
  for (int axis = 0; axis < 3; ++axis)
    if (compliance[(axis + 1) % 3] == 0 && compliance[(axis + 2) % 3] == 0) return axis;
  return -1;
}

}  // namespace

PreparedArm::PreparedArm(const Arm& arm) : arm_(arm), is_fixed_(!dependsOnPosture(arm) && !hasSlide(arm)) {
  if (is_fixed_) prepareFixed();
}

PreparedArm::~PreparedArm() = default;

void PreparedArm::prepareFixed() {
  prepare(arm_, turnsUndone(arm_, VectorXd::Zero(arm_.jointCount())));
  findRevoluteChain(arm_);
  is_prepared_ = true;
}

void PreparedArm::addElement(const Arm& arm, const ChainLink<double>& link) {
  const ComponentState& component = chain_.components[static_cast<std::size_t>(link.component)];
  const Row<double>& row = arm.rows[static_cast<std::size_t>(link.row)];
  FlexibleElement element;
  element.kind = &elementKinds()[static_cast<std::size_t>(component.kind)];
  element.flexibility = element.kind->flexibilityOf(row, link.p);
  element.weight = link.weight;
  if (row.effect_terms && link.type == ChainLinkType::kFlexJoint) {
    element.has_gap = row.effect_terms->has_gap;
    element.gap_width = row.effect_terms->gap;
  }
  element.hinge = hingeOf(element);
  equilibrium_.elements.push_back(element);
  part_ends_.push_back(parts_.size());
  parts_.emplace_back();
}

/// Adds a link to the last rigid part, or starts a new part after it.
void PreparedArm::addLink(const Arm& arm, const std::vector<int>& joints, std::size_t k) {
  const ChainLink<double>& link = chain_.links[k];
  const Row<double>& row = arm.rows[static_cast<std::size_t>(link.row)];
  if (link.component >= 0) return addElement(arm, link);
  RigidPart& part = parts_.back();
  RigidBody& rigid = part.rigid;
  const Vector3d p = rigid.far.R * link.p;
  switch (link.type) {
    case ChainLinkType::kTurn:
      part.has_rotation = true;
      rigid.far.R = rigid.far.R * link.R;
      if (!turns(row.joint)) return;
      part.turn = static_cast<int>(turns_.size());
      turns_.push_back({k, joints[static_cast<std::size_t>(link.row)], row.joint.offset, link.row});
      parts_.emplace_back();
      return;
    case ChainLinkType::kLump:
      rigid.moment += link.weight * (rigid.far.p + rigid.far.R * link.lever);
      break;
    default:
      rigid.moment += link.weight * (rigid.far.p + p / 2);
  }
  rigid.weight += link.weight;
  rigid.far.p += p;
  if (link.type != ChainLinkType::kEndWeight || !row.effect_terms || row.effect_terms->end_force.isZero(0)) return;
  DeadLoad end_force;
  end_force.direction_B = row.effect_terms->end_force;
  end_force.body = static_cast<int>(part_ends_.size());
  hanging_.push_back({equilibrium_.loads.size(), static_cast<int>(parts_.size()) - 1, rigid.far.p});
  equilibrium_.loads.push_back(end_force);
}

/// Adds a force or moment on the tip.
void PreparedArm::addTipLoad(const Vector3d& direction_B, bool is_couple) {
  if (direction_B.isZero(0)) return;
  DeadLoad load;
  load.is_couple = is_couple;
  load.direction_B = direction_B;
  load.at_tip = 1;
  equilibrium_.loads.push_back(load);
}

void PreparedArm::prepare(const Arm& arm, const VectorXd& q) {
  chain_ = assembleChain<double>(arm, arm, q);
  parts_.assign(1, {});
  part_ends_.clear();
  turns_.clear();
  hanging_.clear();
  equilibrium_.elements.clear();
  equilibrium_.loads.assign(1, {});
  equilibrium_.clearances = chain_.clearances;
  // The reach scales tolerances only, and costs more than the rest of an arm with a slide.
  if (!(equilibrium_.reach > 0)) equilibrium_.reach = reachOf(arm_);
  std::vector<int> joints;
  int joint = 0;
  for (const auto& row : arm.rows) joints.push_back(row.joint.type == JointType::kPassive ? -1 : joint++);
  for (std::size_t k = 0; k < chain_.links.size(); ++k) addLink(arm, joints, k);
  part_ends_.push_back(parts_.size());
  if (arm.tip_load) addTipLoad(arm.tip_load->force, false);
  if (arm.tip_load) addTipLoad(arm.tip_load->moment, true);
  equilibrium_.bodies.assign(part_ends_.size(), {});
}

/// Returns the angle by which a joint rotates its link of the assembled chain [rad]. If the joint follows others, the
/// link already includes the joint's offset.
double PreparedArm::angleOf(const JointTurn& turn, const VectorXd& q) const {
  if (turn.joint >= 0) return q[turn.joint] + turn.offset;
  const Arm& arm = effective();
  return followedAngle<double>(arm, arm.rows[static_cast<std::size_t>(turn.row)].joint, q);
}

void PreparedArm::pose(const VectorXd& q) const {
  std::size_t p = 0;
  auto hanging = hanging_.begin();
  for (std::size_t b = 0; b < part_ends_.size(); ++b) {
    RigidBody body;
    for (; p < part_ends_[b]; ++p) {
      const RigidPart& part = parts_[p];
      for (; hanging != hanging_.end() && hanging->part == static_cast<int>(p); ++hanging)
        equilibrium_.loads[hanging->load].place = body.far.p + body.far.R * hanging->place;
      body.moment += body.far.R * part.rigid.moment + part.rigid.weight * body.far.p;
      body.weight += part.rigid.weight;
      body.far.p += body.far.R * part.rigid.far.p;
      if (part.has_rotation) body.far.R = body.far.R * part.rigid.far.R;
      if (part.turn < 0) continue;
      const JointTurn& turn = turns_[static_cast<std::size_t>(part.turn)];
      turnAboutZ(angleOf(turn, q), body.far.R);
    }
    equilibrium_.bodies[b] = body;
  }
}

void PreparedArm::load(const Arm& arm, const Posture& posture) const {
  DeadLoad& gravity = equilibrium_.loads.front();
  gravity.direction_B = posture.gravity_B;
  gravity.at_tip = posture.load;
  gravity.tip_moment.setZero();
  if (!arm.tip_load) return;
  gravity.at_tip -= arm.tip_load->contact_force;
  gravity.tip_moment = posture.load * arm.tip_load->payload_offset;
}

KinematicsStatus PreparedArm::solve(const Posture& posture, const FlexibleKinematicsOptions& options) {
  nominal_posture_ = posture;
  const bool has_context = dependsOnPosture(arm_, nominal_posture_);
  if (!has_context) context_.reset();
  if (has_context) {
    if (!context_) context_.emplace(arm_, nominal_posture_);
    applyEffects(*context_);
    if (!context_->undefined.empty()) {
      undefine();
      return status_;
    }
  }
  const Arm& arm = effective();
  const Posture& effective_posture = effectivePosture();
  if (!is_fixed_ || has_context) {
    prepare(arm, turnsUndone(arm, effective_posture.q));
    findRevoluteChain(arm);
    is_prepared_ = false;
    kernel_variables_.clear();
    kernel_.reset();
  } else if (!is_prepared_) {
    prepareFixed();
  }
  if (revolute_chain_) return solveRevoluteChain(options, {});
  is_copied_out_ = true;
  pose(effective_posture.q);
  load(arm, effective_posture);
  status_ = equilibrium_.converge(options.tolerance * equilibrium_.reach, options.max_iterations);
  iterations_ = equilibrium_.iterations();
  X_BD_ = equilibrium_.tip();
  if (context_) X_BD_ = context_->X_BM * X_BD_;
  return status_;
}

void PreparedArm::undefine() {
  status_ = KinematicsStatus::kUndefined;
  X_BD_ = {};
  X_BD_.p.setConstant(std::numeric_limits<double>::quiet_NaN());
}

std::string PreparedArm::reason() const {
  if (status_ == KinematicsStatus::kUndefined) return context_->undefined;
  if (status_ == KinematicsStatus::kNotConverged)
    return "the deflected shape does not converge: the arm is too compliant for its load";
  return "";
}

/// Calls `visit(k, X)` with the near frame X of every link k, and then with the tip's frame; undeflected if `rigid`.
template <class Visit>
void PreparedArm::walkLinks(bool rigid, Visit&& visit) const {
  copyOutElements();
  const VectorXd& q = effectivePosture().q;
  PoseOf<double> X;
  std::size_t element = 0;
  auto turn = turns_.begin();
  for (std::size_t k = 0; k < chain_.links.size(); ++k) {
    visit(k, X);
    const ChainLink<double>& link = chain_.links[k];
    if (link.component >= 0) {
      const FlexibleElement& flexible = equilibrium_.elements[element++];
      X.p += X.R * (rigid ? link.p : flexible.chord());
      if (!rigid) X.R = X.R * flexible.turn;
    } else {
      X.p += X.R * link.p;
      if (link.type == ChainLinkType::kTurn) X.R = X.R * link.R;
    }
    if (turn == turns_.end() || turn->link != k) continue;
    turnAboutZ(angleOf(*turn, q), X.R);
    ++turn;
  }
  visit(chain_.links.size(), X);
}

void PreparedArm::linkFrames(bool rigid, std::vector<PoseOf<double>>& frames) const {
  frames.resize(chain_.links.size() + 1);
  walkLinks(rigid, [&](std::size_t k, const PoseOf<double>& X) { frames[k] = X; });
}

PoseOf<double> PreparedArm::X_BL(int row) const {
  PoseOf<double> found = X_BD_;  // result if an effect is undefined
  if (status_ == KinematicsStatus::kUndefined) return found;
  walkLinks(false, [&](std::size_t k, const PoseOf<double>& X) {
    if (k < chain_.links.size() && chain_.links[k].type == ChainLinkType::kFrame && chain_.links[k].row == row)
      found = X;
  });
  return context_ ? context_->X_BM * found : found;
}

/// Records the resultant, about each row's origin, of all loads beyond that origin on the deflected shape.
void PreparedArm::recordLoads(const std::vector<PoseOf<double>>& frames, std::vector<RowState>& rows) const {
  const Arm& arm = effective();
  const Vector3d& g = effectivePosture().gravity_B;
  const DeadLoad& gravity = equilibrium_.loads.front();
  Vector3d force = gravity.at_tip * g, moment = Vector3d(frames.back().R * gravity.tip_moment).cross(g);
  if (arm.tip_load) {
    force += arm.tip_load->force;
    moment += arm.tip_load->moment;
  }
  for (std::size_t k = chain_.links.size(); k-- > 0;) {
    const ChainLink<double>& link = chain_.links[k];
    const Vector3d weight = link.weight * g, chord = frames[k + 1].p - frames[k].p;
    const bool hangs_aside = link.type == ChainLinkType::kLump;
    moment +=
        chord.cross(force) + (hangs_aside ? Vector3d(frames[k].R * link.lever) : Vector3d(chord / 2)).cross(weight);
    force += weight;
    const auto& effect_terms = arm.rows[static_cast<std::size_t>(link.row)].effect_terms;
    if (link.type == ChainLinkType::kEndWeight && effect_terms) force += effect_terms->end_force;
    if (link.type != ChainLinkType::kFrame) continue;
    RowState& row = rows[static_cast<std::size_t>(link.row)];
    row.force_B = force;
    row.moment_B = moment;
    row.force_L = frames[k].R.transpose() * force;
    row.moment_L = frames[k].R.transpose() * moment;
  }
}

namespace {

/// Converts a shape from axes of the moved base M to axes of the nominal base.
void moveBase(const PoseOf<double>& X_BM, FlexibleKinematics& shape) {
  shape.X_BT = X_BM * shape.X_BT;
  for (auto& row : shape.rows) {
    row.X_BL_rigid = X_BM * row.X_BL_rigid;
    row.X_BL = X_BM * row.X_BL;
    row.force_B = X_BM.R * row.force_B;
    row.moment_B = X_BM.R * row.moment_B;
  }
}

}  // namespace

FlexibleKinematics PreparedArm::shape() const {
  FlexibleKinematics result;
  result.status = status_;
  result.reason = reason();
  result.rows.resize(arm_.rows.size());
  result.X_BT = result.X_BD = X_BD_;
  result.R_LT = toolFrame(effective());
  if (status_ == KinematicsStatus::kUndefined) return result;
  result.iterations = iterations_;
  std::vector<PoseOf<double>> rigid, deflected;
  linkFrames(true, rigid);
  linkFrames(false, deflected);
  for (std::size_t k = 0; k < chain_.links.size(); ++k) {
    if (chain_.links[k].type != ChainLinkType::kFrame) continue;
    RowState& row = result.rows[static_cast<std::size_t>(chain_.links[k].row)];
    row.X_BL_rigid = rigid[k];
    row.X_BL = deflected[k];
  }
  result.X_BT = rigid.back();
  recordLoads(deflected, result.rows);
  result.components = chain_.components;
  for (std::size_t e = 0; e < result.components.size(); ++e) {
    const FlexibleElement& element = equilibrium_.elements[e];
    result.components[e].displacement = element.deflection.displacement;
    result.components[e].rotation = element.deflection.rotation;
    result.components[e].gap = element.gap;
  }
  if (context_) moveBase(context_->X_BM, result);
  return result;
}

}  // namespace tubeplan::deflection
