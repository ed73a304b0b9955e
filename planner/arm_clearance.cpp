#include "planner/arm_clearance.hpp"

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>

#include "deflection/chain.hpp"
#include "deflection/prepared_arm.hpp"
#include "deflection/rigid_branches.hpp"
#include "deflection/tip_derivatives.hpp"
#include "planner/deflection_travel.hpp"

namespace tubeplan::planner {

namespace {

using deflection::FlexibleKinematics;
using Eigen::Isometry3d, Eigen::Vector3d;

constexpr double kLeastDeflectionFactor = 1.1;
constexpr int kSampledPostures = 96;

/// What the tool's bodies may touch, they may touch on approach only.
Scene travelScene(Scene scene) {
  if (scene.links.empty()) return scene;
  const std::string& tool = scene.links.back().name;
  const auto isTool = [&](const std::string& name) {
    return name == tool || std::any_of(scene.bodies.begin(), scene.bodies.end(),
                                       [&](const Body& body) { return body.link == tool && body.name == name; });
  };
  for (auto& obstacle : scene.obstacles) std::erase_if(obstacle.allow, isTool);
  for (auto& body : scene.bodies)
    if (body.link == tool)
      std::erase_if(body.allow, [&](const std::string& name) {
        return std::any_of(scene.obstacles.begin(), scene.obstacles.end(),
                           [&](const Obstacle& o) { return o.name == name; });
      });
  return scene;
}

Vector3d memberOf(const deflection::Arm& arm, int row) {
  return row + 1 < static_cast<int>(arm.rows.size()) ? deflection::offsetInPreviousAxes<double>(arm.rows[row + 1])
                                                     : arm.p_LT;
}

/// Greatest distance of a bent element from its chord, of the cubic with its end displacement d and end rotation w.
double bowOf(const Vector3d& member, const Vector3d& d, const Vector3d& w) {
  double bow = 0;
  const Vector3d slope = w.cross(member);
  for (double s : {0.25, 1. / 3, 0.5, 2. / 3, 0.75})
    bow = std::max(bow, ((3 * s * s - 2 * s * s * s - s) * d + (s * s * s - s * s) * slope).norm());
  return 1.1 * bow;
}

double bowOfRow(const deflection::Arm& arm, const FlexibleKinematics& shape, int row) {
  double bow = 0, turn = 0;
  int segments = 0;
  for (const auto& component : shape.components) {
    if (component.row != row || deflection::elementKinds()[component.kind].place != deflection::ElementPlace::kMember)
      continue;
    ++segments;
    turn += component.rotation.norm();
    bow = bowOf(memberOf(arm, row), component.displacement, component.rotation);
  }
  return segments > 1 ? 1.1 * memberOf(arm, row).norm() * turn / 8 : bow;
}

/// Far end of a row's member as deflected, in the base frame.
Vector3d farEnd(const FlexibleKinematics& shape, int row) {
  return row + 1 < static_cast<int>(shape.rows.size()) ? shape.rows[row + 1].X_BL.p : shape.X_BD.p;
}

std::vector<Isometry3d> framesAlongChords(const Workcell& cell, const FlexibleKinematics& shape, double* bow) {
  std::vector<Isometry3d> frames;
  if (bow) *bow = 0;
  for (int row = 0; row < static_cast<int>(shape.rows.size()); ++row) {
    Isometry3d X_BL = deflection::toIsometry(shape.rows[row].X_BL);
    if (cell.arm.rows[row].beam && cell.arm.rows[row].joint.type != deflection::JointType::kPrismatic) {
      const Vector3d chord = farEnd(shape, row) - X_BL.translation();
      const Vector3d member = X_BL.linear() * memberOf(cell.arm, row);
      X_BL.linear() = Eigen::Quaterniond::FromTwoVectors(member, chord).toRotationMatrix() * X_BL.linear();
      if (bow) *bow = std::max(*bow, bowOfRow(cell.arm, shape, row));
    }
    frames.push_back(cell.X_WB * X_BL);
  }
  return frames;
}

std::vector<LinkReach> linksOf(const Workcell& cell, const std::vector<double>& body_reach) {
  std::vector<LinkReach> links;
  for (int row = 0; row < static_cast<int>(cell.arm.rows.size()); ++row) {
    const auto& joint = cell.arm.rows[row].joint;
    LinkReach link;
    link.step = memberOf(cell.arm, row).norm();
    link.body = body_reach.at(row);
    link.joint = joint.type == deflection::JointType::kPassive     ? LinkReach::Joint::kNone
                 : joint.type == deflection::JointType::kPrismatic ? LinkReach::Joint::kPrismatic
                                                                   : LinkReach::Joint::kRevolute;
    // A slide lengthens the way from the row before it to its own frame.
    if (joint.type == deflection::JointType::kPrismatic && !links.empty())
      links.back().step += std::max(std::abs(joint.lower + joint.offset), std::abs(joint.upper + joint.offset));
    links.push_back(link);
  }
  return links;
}

}  // namespace

ArmTravel armTravelOf(const Workcell& cell, const std::vector<double>& body_reach) {
  const DeflectionTravel deflection = deflectionTravelOf(cell, body_reach);
  ArmTravel travel;
  travel.is_proved = deflection.is_proved;
  travel.reason = deflection.reason;
  travel.jump = deflection.jump;
  travel.bound =
      travelBoundOf(linksOf(cell, body_reach), deflection.is_proved ? deflection.stretch : deflectionFactor(cell));
  if (deflection.is_proved) travel.bound.reach_per_joint += deflection.per_joint;
  return travel;
}

double deflectionFactor(const Workcell& cell) {
  const auto variables = deflection::jointVariables(cell.arm);
  const deflection::Arm rigid = deflection::rigidCopy(cell.arm);
  const Vector3d gravity_B = deflection::gravityInBase(cell.arm, cell.X_WB);
  const double reach = deflection::reachOf(cell.arm);
  double most = 1;
  for (const auto& q : deflection::latticeStarts(cell.arm, kSampledPostures)) {
    const auto bent = deflection::differentiateTip(cell.arm, {q, cell.load, gravity_B}, variables);
    const auto straight = deflection::differentiateTip(rigid, {q, cell.load, gravity_B}, variables);
    if (bent.kinematics.status != deflection::KinematicsStatus::kConverged) continue;
    for (int k = 0; k < bent.position_B.cols(); ++k) {
      const double extra = (bent.position_B.col(k) - straight.position_B.col(k)).norm();
      // Against a lever of a quarter of the reach at least: short ones are bounded by their longest posture, not by
      // this one.
      most = std::max(most, 1 + extra / std::max(straight.position_B.col(k).norm(), reach / 4));
    }
  }
  return std::max(kLeastDeflectionFactor, 1 + 1.1 * (most - 1));
}

std::vector<Isometry3d> bodyFrames(const Workcell& cell, const Eigen::VectorXd& q, double* bow) {
  const auto shape =
      deflection::solveFlexibleKinematics(cell.arm, {q, cell.load, deflection::gravityInBase(cell.arm, cell.X_WB)});
  if (shape.status != deflection::KinematicsStatus::kConverged) return {};
  return framesAlongChords(cell, shape, bow);
}

struct ArmClearance::PreparedArms {
  explicit PreparedArms(const Workcell& cell)
      : gravity_B(deflection::gravityInBase(cell.arm, cell.X_WB)),
        of_thread([&arm = cell.arm] { return deflection::PreparedArm(arm); }) {}

  Vector3d gravity_B;
  oneapi::tbb::enumerable_thread_specific<deflection::PreparedArm> of_thread;
};

ArmClearance::~ArmClearance() = default;

ArmClearance::ArmClearance(const Workcell& cell)
    : cell_(cell),
      arms_(std::make_unique<PreparedArms>(cell)),
      approach_world_(cell.scene),
      travel_world_(travelScene(cell.scene)),
      travel_(armTravelOf(cell, approach_world_.bodyReach())) {}

Clearance ArmClearance::at(const Eigen::VectorXd& q, ContactRule rule) const {
  double bow = 0;
  Clearance clearance;
  deflection::PreparedArm& arm = arms_->of_thread.local();
  if (arm.solve({q, cell_.load, arms_->gravity_B}) != deflection::KinematicsStatus::kConverged) {
    clearance.other = "the deflected shape does not settle";
    return clearance;
  }
  const auto frames = framesAlongChords(cell_, arm.shape(), &bow);
  clearance = (rule == ContactRule::kTravel ? travel_world_ : approach_world_).closest(frames);
  clearance.distance -= bow + travel_.jump;
  clearance.margin -= bow + travel_.jump;
  return clearance;
}

Clearance ArmClearance::withSpare(const Eigen::VectorXd& q, ContactRule rule, double spare) const {
  Clearance clearance = at(q, rule);
  clearance.margin -= spare;
  return clearance;
}

}  // namespace tubeplan::planner
