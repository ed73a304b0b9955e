#include "app/files/urdf_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <urdf_model/model.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "app/files/input_error.hpp"
#include "app/files/suggestion.hpp"
#include "app/files/units.hpp"
#include "app/files/urdf_tree.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::app {

namespace {

using deflection::JointType;
using Eigen::Isometry3d, Eigen::Matrix3d, Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;

Isometry3d poseOf(const urdf::Pose& pose) {
  const Eigen::Quaterniond turn(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
  Isometry3d X = Isometry3d::Identity();
  X.linear() = turn.normalized().toRotationMatrix();
  X.translation() << pose.position.x, pose.position.y, pose.position.z;
  return X;
}

/// The smallest turn that takes z to the joint's axis.
Isometry3d alignment(const urdf::Joint& joint) {
  Isometry3d X = Isometry3d::Identity();
  if (joint.type == urdf::Joint::FIXED) return X;
  const Vector3d axis(joint.axis.x, joint.axis.y, joint.axis.z);
  X.linear() = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), axis).toRotationMatrix();
  return X;
}

bool isMoving(const urdf::Joint& joint) { return joint.type != urdf::Joint::FIXED; }
bool isTurning(const urdf::Joint& joint) {
  return joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS;
}

using Chain = std::vector<urdf::LinkConstSharedPtr>;

/// The links from the first behind the root to this one. The parser lets links hang on each other in a circle.
Chain chainTo(const urdf::ModelInterface& model, const urdf::LinkConstSharedPtr& tip, const std::string& file) {
  Chain chain;
  for (auto link = tip; link && link->parent_joint; link = link->getParent()) {
    if (chain.size() == model.links_.size())
      throw InputError(file, "links that form a closed loop, " + inQuotes(tip->name) + " behind them",
                       "a tree of links with one root");
    chain.push_back(link);
  }
  std::reverse(chain.begin(), chain.end());
  return chain;
}

urdf::LinkConstSharedPtr findTip(const urdf::ModelInterface& model, const std::string& name, const std::string& file) {
  const auto depthOf = [&](const urdf::LinkConstSharedPtr& link) {
    const Chain chain = chainTo(model, link, file);
    return std::count_if(chain.begin(), chain.end(), [](const auto& at) { return isMoving(*at->parent_joint); });
  };
  std::vector<std::string> names;
  for (const auto& [link_name, link] : model.links_) names.push_back(link_name);
  if (!name.empty()) {
    if (const auto link = model.getLink(name)) return link;
    throw InputError(file, "no link " + inQuotes(name), "a link of the robot", suggestion(name, names));
  }
  std::vector<urdf::LinkConstSharedPtr> deepest;
  for (const auto& [link_name, link] : model.links_) {
    if (!link->child_links.empty()) continue;
    const auto depth = depthOf(link), most = deepest.empty() ? -1 : depthOf(deepest.front());
    if (depth > most) deepest.clear();
    if (depth >= most) deepest.push_back(link);
  }
  if (deepest.size() == 1) return deepest.front();
  std::vector<std::string> tips;
  for (const auto& link : deepest) tips.push_back(link->name);
  throw InputError(file, fmt::format("{} links at the end of equally long chains", tips.size()),
                   "one, named by --tip: " + alternatives(tips));
}

/// The chain as rows; `X_LK` leads from a row's frame to its link's.
class ChainReader {
 public:
  ChainReader(const urdf::ModelInterface& model, const urdf::LinkConstSharedPtr& tip, const std::string& file)
      : model_(model), file_(file), links_(chainTo(model, tip, file)) {
    last_moving_ = links_.size();
    while (last_moving_ > 0 && !isMoving(*links_[last_moving_ - 1]->parent_joint)) --last_moving_;
    if (last_moving_ == 0)
      throw InputError(file_, "no moving joint between the root and " + inQuotes(tip->name), "one or more",
                       "another link may be meant by --tip");
  }

  UrdfArm read() {
    out_.arm.name = model_.getName();
    out_.tip = links_.back()->name;
    leaveOutStanding(*model_.getRoot());
    for (std::size_t k = 0; k < last_moving_; ++k) addRow(*links_[k]);
    for (std::size_t k = 0; k < last_moving_; ++k) addFollowing(k);
    for (std::size_t k = 0; k < last_moving_; ++k) addAside(k, *links_[k], X_LK_[k]);
    Isometry3d X_LT = X_LK_.back();
    for (std::size_t k = last_moving_; k < links_.size(); ++k) {
      X_LT = X_LT * addJoint(*links_[k]->parent_joint, Isometry3d::Identity());
      addBody(last_moving_ - 1, *links_[k], X_LT);
      addAside(last_moving_ - 1, *links_[k], X_LT);
    }
    out_.arm.p_LT = X_LT.translation();
    out_.arm.tool_axis_L = X_LT.linear().col(2);
    out_.arm.R_LT = X_LT.linear();
    if (has_inertia_) out_.left_out.emplace_back("moments of inertia: not needed for statics");
    return std::move(out_);
  }

 private:
  [[nodiscard]] bool isOnChain(const urdf::Link& link) const {
    return std::any_of(links_.begin(), links_.end(), [&](const auto& other) { return other->name == link.name; });
  }

  /// Its origin.
  Isometry3d addJoint(const urdf::Joint& joint, const Isometry3d& X_CL) {
    const Isometry3d X_PC = poseOf(joint.parent_to_joint_origin_transform);
    out_.joints.push_back({joint.name, X_PC, X_CL, deflection::fixedAnglesOf(X_PC.linear())});
    return X_PC;
  }

  void addRow(const urdf::Link& link) {
    const urdf::Joint& joint = *link.parent_joint;
    const Isometry3d X_KL = alignment(joint), before = X_LK_.empty() ? Isometry3d::Identity() : X_LK_.back();
    const Isometry3d X = before * addJoint(joint, X_KL) * X_KL;
    auto& row = out_.arm.rows.emplace_back();
    row.name = nameOfRow(link.name);
    row.placement = deflection::Origin<double>{X.translation(), deflection::fixedAnglesOf(X.linear())};
    if (isMoving(joint)) row.joint = jointOf(joint);
    X_LK_.push_back(X_KL.inverse());
    addBody(out_.arm.rows.size() - 1, link, X_LK_.back());
  }

  /// Without the characters that paths to an arm's numbers are made of.
  [[nodiscard]] std::string nameOfRow(std::string name) const {
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '.' || c == '[' || c == ']' || c == ' '; }, '_');
    const auto isTaken = [&](const std::string& one) {
      return std::any_of(out_.arm.rows.begin(), out_.arm.rows.end() - 1,
                         [&](const auto& row) { return row.name == one; });
    };
    while (isTaken(name)) name += '_';
    return name;
  }

  [[nodiscard]] std::string at(const urdf::Joint& joint) const {
    return fmt::format("{} (joint {})", file_, nameInLine(joint.name));
  }

  deflection::Joint<double> jointOf(const urdf::Joint& from) {
    deflection::Joint<double> joint;
    joint.name = from.name;
    switch (from.type) {
      case urdf::Joint::REVOLUTE:
      case urdf::Joint::CONTINUOUS:
        joint.type = JointType::kRevolute;
        break;
      case urdf::Joint::PRISMATIC:
        joint.type = JointType::kPrismatic;
        break;
      default:
        throw InputError(at(from), "a floating or planar joint", "joints that turn about or slide along one axis");
    }
    if (Vector3d(from.axis.x, from.axis.y, from.axis.z).isZero())
      throw InputError(at(from), "an axis of length zero", "a direction");
    if (from.limits && from.type != urdf::Joint::CONTINUOUS) setLimits(from, joint);
    if (from.limits && from.limits->velocity > 0) joint.max_speed = from.limits->velocity;
    return joint;
  }

  /// Two zeros are what URDF has where no limits are written.
  void setLimits(const urdf::Joint& from, deflection::Joint<double>& joint) {
    const double lower = from.limits->lower, upper = from.limits->upper;
    if (lower == 0 && upper == 0) {
      out_.left_out.push_back(
          fmt::format("limits of joint {}: lower and upper are both 0, so it has none", nameInLine(from.name)));
      return;
    }
    if (!(lower < upper))
      throw InputError(at(from), fmt::format("limits from {} to {}", formatNumber(lower), formatNumber(upper)),
                       "lower below upper", "one that is not written is 0; a joint that stands still is of type fixed");
    joint.lower = lower;
    joint.upper = upper;
  }

  /// How a joint follows one that has a reading of its own, through those between.
  struct Following {
    std::size_t leader;  ///< of links_
    double ratio, offset;
  };

  [[nodiscard]] Following followingOf(const urdf::Joint& from) const {
    const urdf::Joint* at_joint = &from;
    Following found{0, 1, 0};
    for (std::size_t steps = 0; at_joint->mimic; ++steps) {
      const auto& mimic = *at_joint->mimic;
      const auto leader = std::find_if(links_.begin(), links_.end(),
                                       [&](const auto& link) { return link->parent_joint->name == mimic.joint_name; });
      found = {static_cast<std::size_t>(leader - links_.begin()), found.ratio * mimic.multiplier,
               found.offset + found.ratio * mimic.offset};
      if (found.leader >= last_moving_ || steps > links_.size())
        throw InputError(
            at(from), "a joint that mimics " + inQuotes(mimic.joint_name),
            leader == links_.end() ? "a joint on the way to the tip" : "a moving joint of its own reading");
      at_joint = links_[found.leader]->parent_joint.get();
    }
    return found;
  }

  /// A joint that mimics another: a passive row that follows it.
  void addFollowing(std::size_t k) {
    const urdf::Joint& from = *links_[k]->parent_joint;
    if (!from.mimic) return;
    auto& joint = out_.arm.rows[k].joint;
    const Following following = followingOf(from);
    if (joint.type != JointType::kRevolute || !isTurning(*links_[following.leader]->parent_joint))
      throw InputError(at(from), "a joint that mimics " + inQuotes(from.mimic->joint_name), "turning joints");
    joint = {.name = joint.name, .type = JointType::kPassive, .offset = following.offset};
    joint.follows = {{static_cast<int>(following.leader), following.ratio}};
  }

  void addBody(std::size_t row, const urdf::Link& link, const Isometry3d& X_LK) {
    if (link.inertial && link.inertial->mass > 0) {
      const Vector3d centre = X_LK * poseOf(link.inertial->origin).translation();
      out_.arm.rows[row].weight.lumps.push_back({kWeightOfKilogram * link.inertial->mass, centre});
      has_inertia_ = has_inertia_ || link.inertial->ixx > 0;
    }
    for (const auto& collision : link.collision_array)
      if (collision && collision->geometry) addShape(out_.arm.rows[row].name, *collision, X_LK);
  }

  /// What hangs on a link of the chain beside it: fixed parts with it, others not.
  void addAside(std::size_t row, const urdf::Link& link, const Isometry3d& X_LK) {
    for (const auto& child : link.child_links) {
      if (isOnChain(*child)) continue;
      if (isMoving(*child->parent_joint)) {
        out_.left_out.push_back(sideBranch(*child));
        continue;
      }
      const Isometry3d X = X_LK * poseOf(child->parent_joint->parent_to_joint_origin_transform);
      addBody(row, *child, X);
      addAside(row, *child, X);
    }
  }

  /// Solids of what stands with the root do not move with a row.
  void leaveOutStanding(const urdf::Link& link) {
    if (!link.collision_array.empty())
      out_.left_out.push_back(
          fmt::format("the solids of link {}, which stands still: write them into the cell's scene", link.name));
    for (const auto& child : link.child_links) {
      if (isOnChain(*child)) continue;
      if (isMoving(*child->parent_joint))
        out_.left_out.push_back(sideBranch(*child));
      else
        leaveOutStanding(*child);
    }
  }

  static std::string sideBranch(const urdf::Link& link) {
    return fmt::format("link {} and what it carries: joint {} is not on the way to the tip", link.name,
                       link.parent_joint->name);
  }

  void addShape(const std::string& row, const urdf::Collision& collision, const Isometry3d& X_LK) {
    const Isometry3d X = X_LK * poseOf(collision.origin);
    const auto text = [](const Vector3d& v) {
      return fmt::format("[{}, {}, {}]", formatNumber(v.x()), formatNumber(v.y()), formatNumber(v.z()));
    };
    const auto& geometry = *collision.geometry;
    if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(&geometry)) {
      const Vector3d half = X.linear().col(2) * cylinder->length / 2;
      out_.shapes.push_back(
          {row, fmt::format("cylinder: {{from: {}, to: {}, radius: {}}}", text(X.translation() - half),
                            text(X.translation() + half), formatNumber(cylinder->radius))});
    } else if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(&geometry)) {
      out_.shapes.push_back({row, fmt::format("sphere: {{center: {}, radius: {}}}", text(X.translation()),
                                              formatNumber(sphere->radius))});
    } else if (const auto* box = dynamic_cast<const urdf::Box*>(&geometry)) {
      out_.shapes.push_back({row, fmt::format("box: {{center: {}, size: {}, rpy: {}}}", text(X.translation()),
                                              text({box->dim.x, box->dim.y, box->dim.z}),
                                              text(deflection::fixedAnglesOf(X.linear()) / kDegree))});
    } else if (const auto* mesh = dynamic_cast<const urdf::Mesh*>(&geometry)) {
      out_.left_out.push_back(
          fmt::format("the mesh {} of row {}: write it into the cell's link_shapes", mesh->filename, row));
    }
  }

  const urdf::ModelInterface& model_;
  const std::string& file_;
  Chain links_;
  std::size_t last_moving_ = 0;   ///< rows: links up to the last one that a moving joint carries
  std::vector<Isometry3d> X_LK_;  ///< of each row
  bool has_inertia_ = false;
  UrdfArm out_;
};

/// What is told to the controllers of the chain's joints, a sentence of each sort.
std::vector<std::string> leftToControllers(const Chain& chain, const UrdfTree& tree) {
  const struct {
    std::string ControllerWords::*words;
    const char *what, *instead;
  } sorts[] = {
      {&ControllerWords::soft_limits, "soft limits (safety_controller)", "the arm has the hard ones of <limit>"},
      {&ControllerWords::reference_marks, "reference marks (calibration)",
       "readings count from the joint's zero, as the controller shows them"},
      {&ControllerWords::transmission, "transmissions", "readings are the joint's, not its motor's"},
  };
  std::vector<std::string> sentences;
  for (const auto& [words, what, instead] : sorts) {
    std::vector<std::string> joints;
    for (const auto& link : chain)
      if (const auto found = tree.controllers.find(link->parent_joint->name);
          found != tree.controllers.end() && !(found->second.*words).empty())
        joints.push_back(nameInLine(found->first) + found->second.*words);
    if (!joints.empty()) sentences.push_back(fmt::format("{}: {}; {}", what, fmt::join(joints, ", "), instead));
  }
  return sentences;
}

}  // namespace

UrdfArm parseUrdf(const std::string& text, const std::string& file, const std::string& tip) {
  const UrdfTree tree = readUrdfTree(text, file);
  const auto end = findTip(*tree.model, tip, file);
  UrdfArm read = ChainReader(*tree.model, end, file).read();
  for (auto& joint : read.joints)
    if (const auto written = tree.turns.find(joint.name); written != tree.turns.end())
      joint.rpy = Vector3d(written->second.data());
  const Chain chain = chainTo(*tree.model, end, file);
  read.remarks = remarksOnNumbers(chain, tree.turns);
  std::ranges::move(leftToControllers(chain, tree), std::back_inserter(read.left_out));
  read.left_out.insert(read.left_out.begin(), tree.left_out.begin(), tree.left_out.end());
  const auto problems = deflection::findProblems(read.arm);
  if (!problems.empty())
    throw InputError(fmt::format("{} ({})", file, problems.front().path), problems.front().found,
                     problems.front().expected);
  return read;
}

}  // namespace tubeplan::app
