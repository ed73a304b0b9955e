#include "planner/collision/arm_clearance.hpp"

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "deflection/chain.hpp"
#include "deflection/frames_along_chords.hpp"
#include "deflection/inverse/rigid_branches.hpp"
#include "deflection/tip_derivatives.hpp"
#include "planner/collision/anchored_reach.hpp"
#include "planner/collision/deflection_travel.hpp"
#include "planner/collision/nearest_pairs.hpp"

namespace tubeplan::planner {

namespace {

using Eigen::Isometry3d, Eigen::Vector3d;

constexpr double kLeastDeflectionFactor = 1.1;
constexpr int kSampledPostures = 96;

/// Returns the scene for travel between tubes: the tool may not touch even obstacles that `allow` lists permit on
/// approach.
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

std::vector<LinkReach> linksOf(const AnchoredReach& anchored) {
  std::vector<LinkReach> links;
  for (int row = 0; row < static_cast<int>(anchored.arm.rows.size()); ++row) {
    const auto& joint = anchored.arm.rows[row].joint;
    LinkReach link;
    link.step = deflection::memberOf(anchored.arm, row).norm();
    link.body = anchored.body_reach.at(row);
    link.joint = joint.type == deflection::JointType::kPassive     ? LinkReach::Joint::kNone
                 : joint.type == deflection::JointType::kPrismatic ? LinkReach::Joint::kPrismatic
                                                                   : LinkReach::Joint::kRevolute;
    link.follows = joint.follows;
    // A prismatic joint increases the distance from the previous row's origin to its own row's origin.
    if (!links.empty()) links.back().step += deflection::slideLength(joint);
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
  travel.bound = travelBoundOf(linksOf(anchoredReachOf(cell.arm, cell.scene, body_reach)),
                               deflection.is_proved ? deflection.stretch : deflectionFactor(cell));
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
      // Lower bound of a quarter of the reach on the rigid motion per rad: a joint with a short lever arm in this
      // posture has a longer one in another posture, and the longest one determines the joint's bound.
      most = std::max(most, 1 + extra / std::max(straight.position_B.col(k).norm(), reach / 4));
    }
  }
  return std::max(kLeastDeflectionFactor, 1 + 1.1 * (most - 1));
}

std::vector<Isometry3d> bodyFrames(const Workcell& cell, const Eigen::VectorXd& q, double* bow) {
  const auto shape =
      deflection::solveFlexibleKinematics(cell.arm, {q, cell.load, deflection::gravityInBase(cell.arm, cell.X_WB)});
  if (shape.status != deflection::KinematicsStatus::kConverged) return {};
  return deflection::framesAlongChords(cell.arm, cell.X_WB, shape, bow);
}

struct ArmClearance::PreparedArms {
  explicit PreparedArms(const Workcell& cell)
      : approach(cell.scene),
        travel(travelScene(cell.scene)),
        of_thread([&cell] { return deflection::RowPlacing(cell.arm, cell.load, cell.X_WB); }) {}

  NearestPairs approach, travel;
  oneapi::tbb::enumerable_thread_specific<deflection::RowPlacing> of_thread;
};

ArmClearance::~ArmClearance() = default;

ArmClearance::ArmClearance(const Workcell& cell, double padding)
    : cell_(cell),
      padding_(cell, padding),
      arms_(std::make_unique<PreparedArms>(cell)),
      travel_(armTravelOf(cell, bodyReachOf(cell.scene))) {
  travel_.bound.reach_per_joint *= 1 + padding_.slope();
}

void ArmClearance::find(const NearestPairs& pairs, const deflection::PlacedRows& placed,
                        std::span<NearestPair> found) const {
  if (padding_.isNone()) return pairs.find(placed, found);
  for (int lane = 0; lane < placed.count; ++lane)
    found[static_cast<std::size_t>(lane)] = pairs.findPadded(placed, lane, padding_);
}

Clearance ArmClearance::reducedByBow(Clearance clearance, double bow) const {
  clearance.distance -= bow + travel_.jump;
  clearance.margin -= bow + travel_.jump;
  return clearance;
}

Clearance ArmClearance::at(const Eigen::VectorXd& q, ContactRule rule) const {
  const NearestPairs& pairs = rule == ContactRule::kTravel ? arms_->travel : arms_->approach;
  const deflection::PlacedRows& placed = arms_->of_thread.local().place(q);
  NearestPair found;
  find(pairs, placed, {&found, 1});
  return reducedByBow(pairs.named(placed, 0, found), placed.bow.front());
}

MarginsSideBySide ArmClearance::together(const PostureColumns& q, ContactRule rule) const {
  const NearestPairs& pairs = rule == ContactRule::kTravel ? arms_->travel : arms_->approach;
  deflection::RowPlacing& placing = arms_->of_thread.local();
  MarginsSideBySide result;
  std::array<NearestPair, kernels::kMostLanes> found;
  for (Eigen::Index first = 0; first < q.cols(); first += placing.lanes()) {
    const deflection::PlacedRows& placed = placing.place(q, first);
    find(pairs, placed, found);
    std::optional<std::size_t> tightest;
    for (std::size_t l = 0; l < static_cast<std::size_t>(placed.count); ++l) {
      result.margins.push_back(found[l].distance - cell_.scene.clearance - (placed.bow[l] + travel_.jump));
      const double least = result.margins[result.tightest];
      if (result.margins.size() > 1 && (std::isnan(least) || result.margins.back() >= least)) continue;
      result.tightest = result.margins.size() - 1;
      tightest = l;
    }
    if (tightest)
      result.clearance =
          reducedByBow(pairs.named(placed, static_cast<int>(*tightest), found[*tightest]), placed.bow[*tightest]);
  }
  return result;
}

Clearance ArmClearance::withSpare(const Eigen::VectorXd& q, ContactRule rule, double spare) const {
  Clearance clearance = at(q, rule);
  clearance.margin -= spare;
  return clearance;
}

}  // namespace tubeplan::planner
