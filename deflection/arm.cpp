#include "deflection/arm.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "deflection/chain.hpp"
#include "deflection/effects/effect.hpp"
#include "deflection/shortest_chain.hpp"

namespace tubeplan::deflection {

Eigen::Matrix3d toolFrame(const Arm& arm) { return rotationFromVector<double>(arm.tool_turn_L) * arm.R_LT; }

std::vector<int> activeRows(const Arm& arm) {
  std::vector<int> active;
  for (int i = 0; i < static_cast<int>(arm.rows.size()); ++i)
    if (arm.rows[i].joint.type != JointType::kPassive) active.push_back(i);
  return active;
}

std::vector<FollowedJoint> turnedWith(const Arm& arm, int active_row) {
  std::vector<FollowedJoint> turned{{active_row, 1}};
  for (int i = 0; i < static_cast<int>(arm.rows.size()); ++i)
    for (const FollowedJoint& followed : arm.rows[static_cast<std::size_t>(i)].joint.follows)
      if (followed.row == active_row) turned.push_back({i, followed.ratio});
  return turned;
}

bool isNearlyParallel(const Row<double>& row) {
  constexpr double kCosine = 0.866;  // cosine of 30 degrees, the largest angle between nearly parallel axes
  return std::abs(rotationFromPrevious<double>(row)(2, 2)) > kCosine;
}

std::vector<std::string> jointNames(const Arm& arm) {
  std::vector<std::string> names;
  for (const auto& joint : arm.joints()) names.push_back(joint.name);
  return names;
}

std::vector<std::string> rowNames(const Arm& arm) {
  std::vector<std::string> names;
  for (const auto& row : arm.rows) names.push_back(row.name);
  return names;
}

std::optional<int> findRow(const Arm& arm, std::string_view name) {
  const auto found = std::find_if(arm.rows.begin(), arm.rows.end(), [&](const auto& row) { return row.name == name; });
  if (found == arm.rows.end()) return std::nullopt;
  return static_cast<int>(found - arm.rows.begin());
}

bool hasFollowers(const Arm& arm) {
  return std::any_of(arm.rows.begin(), arm.rows.end(), [](const auto& row) { return !row.joint.follows.empty(); });
}

bool isCompliant(const Row<double>& row) { return row.beam || std::isfinite(row.joint_stiffness.minCoeff()); }

Arm rigidCopy(const Arm& arm) {
  Arm rigid = arm;
  for (auto& row : rigid.rows) {
    row.joint_stiffness.setConstant(kRigid);
    row.beam.reset();
  }
  rigid.mountings.clear();
  std::erase_if(rigid.effects,
                [](const Effect& effect) { return effectKinds().at(effect.kind).stage == EffectStage::kFlexibility; });
  return rigid;
}

std::pair<double, double> rangeOf(const Arm& arm, const Joint<double>& joint) {
  const double span = joint.type == JointType::kPrismatic ? reachOf(arm) : std::numbers::pi;
  return {std::isfinite(joint.lower) ? joint.lower : -span, std::isfinite(joint.upper) ? joint.upper : span};
}

Eigen::Vector3d memberOf(const Arm& arm, int row) { return offsetToNext<double>(arm, static_cast<std::size_t>(row)); }

Eigen::Vector3d undeflectedMember(const Arm& arm, int row) {
  return arm.rows.at(row).joint.type == JointType::kPrismatic ? Eigen::Vector3d::UnitZ() : memberOf(arm, row);
}

double slideLength(const Joint<double>& joint) {
  if (joint.type != JointType::kPrismatic) return 0;
  return std::max(std::abs(joint.lower + joint.offset), std::abs(joint.upper + joint.offset));
}

double reachOf(const Arm& arm) {
  std::vector<ChainLine> chain{{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), false}};
  PoseOf<double> X_BL;
  double slides = 0;
  for (const auto& row : arm.rows) {
    X_BL = X_BL * PoseOf<double>{rotationFromPrevious<double>(row), offsetInPreviousAxes<double>(row)};
    if (turns(row.joint)) chain.push_back({X_BL.p, X_BL.R.col(2)});
    const double slide = slideLength(row.joint);
    slides += std::isfinite(slide) ? slide : 0;
  }
  chain.push_back({X_BL.p + X_BL.R * arm.p_LT, Eigen::Vector3d::UnitZ(), false});
  shortenChain(chain);
  return chainLength(chain) + slides;
}

}  // namespace tubeplan::deflection
