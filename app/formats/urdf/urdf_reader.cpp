#include "app/formats/urdf/urdf_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "app/formats/units.hpp"
#include "app/formats/urdf/urdf_remarks.hpp"
#include "app/formats/urdf/urdf_tips.hpp"
#include "app/formats/urdf/urdf_tree.hpp"
#include "app/storage/input_question.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::app {

namespace {

using deflection::JointType;
using Eigen::Isometry3d, Eigen::Matrix3d, Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;

using Link = UrdfTree::Link;

/// Returns the smallest rotation of the z axis to the joint's axis; identity for a fixed joint.
Isometry3d alignment(const UrdfTree::Joint& joint) {
  Isometry3d X = Isometry3d::Identity();
  if (joint.type != "fixed")
    X.linear() = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), joint.axis).toRotationMatrix();
  return X;
}

bool isTurning(const UrdfTree::Joint& joint) { return joint.type == "revolute" || joint.type == "continuous"; }

/// Converter of a chain of links to rows of an arm; `X_LK` is the pose of a link's frame K relative to its row's frame
/// L.
class ChainReader {
 public:
  ChainReader(const UrdfTree& tree, const Link& tip, const std::string& file)
      : tree_(tree), file_(file), links_(chainTo(tree, tip, file)) {
    last_moving_ = links_.size();
    while (last_moving_ > 0 && !isMoving(*links_[last_moving_ - 1]->joint)) --last_moving_;
    if (last_moving_ == 0)
      throw TipError(InputError::problem(file_, "there is no moving joint between the root and " + inQuotes(tip.name),
                                         "select another link with --tip"));
  }

  UrdfArm read() {
    out_.arm.name = tree_.name;
    out_.tip = links_.back()->name;
    leaveOutStanding(*tree_.root);
    for (std::size_t k = 0; k < last_moving_; ++k) addRow(*links_[k]);
    for (std::size_t k = 0; k < last_moving_; ++k) addFollowing(k);
    for (std::size_t k = 0; k < last_moving_; ++k) addAside(k, *links_[k], X_LK_[k]);
    Isometry3d X_LT = X_LK_.back();
    for (std::size_t k = last_moving_; k < links_.size(); ++k) {
      X_LT = X_LT * addJoint(*links_[k]->joint, Isometry3d::Identity());
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
  [[nodiscard]] bool isOnChain(const Link& link) const {
    return std::any_of(links_.begin(), links_.end(), [&](const Link* other) { return other == &link; });
  }

  /// Appends a joint to the output and returns the joint's origin.
  Isometry3d addJoint(const UrdfTree::Joint& joint, const Isometry3d& X_CL) {
    const Isometry3d X_PC = joint.origin.pose();
    out_.joints.push_back({joint.name, X_PC, X_CL, joint.origin.rpy});
    return X_PC;
  }

  void addRow(const Link& link) {
    const UrdfTree::Joint& joint = *link.joint;
    const Isometry3d X_KL = alignment(joint), before = X_LK_.empty() ? Isometry3d::Identity() : X_LK_.back();
    const Isometry3d X = before * addJoint(joint, X_KL) * X_KL;
    auto& row = out_.arm.rows.emplace_back();
    row.name = nameOfRow(link.name);
    row.placement = deflection::Origin<double>{X.translation(), deflection::fixedAnglesOf(X.linear())};
    if (isMoving(joint)) row.joint = jointOf(joint);
    X_LK_.push_back(X_KL.inverse());
    addBody(out_.arm.rows.size() - 1, link, X_LK_.back());
  }

  /// Returns a unique name of a row without characters that have a meaning in paths of parameters.
  [[nodiscard]] std::string nameOfRow(std::string name) const {
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '.' || c == '[' || c == ']' || c == ' '; }, '_');
    const auto isTaken = [&](const std::string& candidate) {
      return std::any_of(out_.arm.rows.begin(), out_.arm.rows.end() - 1,
                         [&](const auto& row) { return row.name == candidate; });
    };
    while (isTaken(name)) name += '_';
    return name;
  }

  [[nodiscard]] std::string at(const UrdfTree::Joint& joint) const {
    return fmt::format("{} (joint {})", file_, nameInLine(joint.name));
  }

  deflection::Joint<double> jointOf(const UrdfTree::Joint& from) {
    deflection::Joint<double> joint;
    joint.name = from.name;
    if (from.type == "floating" || from.type == "planar")
      throw InputError(at(from), "a " + from.type + " joint", "one that turns about or slides along one axis");
    joint.type = isTurning(from) ? JointType::kRevolute : JointType::kPrismatic;
    if (from.axis.isZero()) throw InputError(at(from), "an axis of length zero", "an axis that is not zero");
    if (from.limits && from.type != "continuous") setLimits(from, joint);
    if (from.limits && from.limits->velocity > 0) joint.max_speed = from.limits->velocity;
    return joint;
  }

  /// Sets a joint's limits, unless both are zero, which means that the file states none.
  void setLimits(const UrdfTree::Joint& from, deflection::Joint<double>& joint) {
    const double lower = from.limits->lower, upper = from.limits->upper;
    if (lower == 0 && upper == 0) {
      out_.left_out.push_back(
          fmt::format("limits of joint {}: lower and upper are both 0, so it has none", nameInLine(from.name)));
      return;
    }
    if (!(lower < upper))
      throw InputError(
          at(from), fmt::format("limits from {} to {}", formatNumber(lower), formatNumber(upper)),
          "a lower limit below the upper limit",
          "write both limits (a missing one counts as 0), or use type fixed for a joint that does not move");
    joint.lower = lower;
    joint.upper = upper;
  }

  /// Coupling of a joint to a leader with a reading of its own, combined over intermediate joints with `mimic`.
  struct Following {
    std::size_t leader;  ///< index of the leader in links_
    double ratio, offset;
  };

  [[nodiscard]] Following followingOf(const UrdfTree::Joint& from) const {
    const UrdfTree::Joint* at_joint = &from;
    Following found{0, 1, 0};
    for (std::size_t steps = 0; at_joint->mimic; ++steps) {
      const auto& mimic = *at_joint->mimic;
      const auto leader = std::find_if(links_.begin(), links_.end(),
                                       [&](const auto& link) { return link->joint->name == mimic.joint; });
      found = {static_cast<std::size_t>(leader - links_.begin()), found.ratio * mimic.multiplier,
               found.offset + found.ratio * mimic.offset};
      if (leader == links_.end())
        throw TipError(
            InputError::problem(at(from),
                                fmt::format("the joint mimics {}, which is not in the chain from the base to the tip",
                                            inQuotes(mimic.joint)),
                                "choose a tip whose chain contains both joints, or remove the mimic"));
      if (found.leader >= last_moving_ || steps > links_.size())
        throw InputError::problem(
            at(from),
            fmt::format("the joint mimics {}, which is not a moving joint with a reading of its own",
                        inQuotes(mimic.joint)),
            "let it mimic another joint, or remove the mimic");
      at_joint = &*links_[found.leader]->joint;
    }
    return found;
  }

  /// Converts a joint with `mimic` to a passive row that follows another joint.
  void addFollowing(std::size_t k) {
    const UrdfTree::Joint& from = *links_[k]->joint;
    if (!from.mimic) return;
    auto& joint = out_.arm.rows[k].joint;
    const Following following = followingOf(from);
    if (joint.type != JointType::kRevolute || !isTurning(*links_[following.leader]->joint))
      throw InputError::problem(at(from),
                                fmt::format("the joint mimics {}, but only turning joints can follow one another",
                                            inQuotes(from.mimic->joint)));
    joint = {.name = joint.name, .type = JointType::kPassive, .offset = following.offset};
    joint.follows = {{static_cast<int>(following.leader), following.ratio}};
  }

  void addBody(std::size_t row, const Link& link, const Isometry3d& X_LK) {
    if (link.mass > 0) {
      out_.arm.rows[row].weight.lumps.push_back({kWeightOfKilogram * link.mass, X_LK * link.centre});
      has_inertia_ = has_inertia_ || link.has_inertia;
    }
    for (const auto& solid : link.solids) addShape(out_.arm.rows[row].name, solid, X_LK);
  }

  /// Adds the links that branch off the chain: fixed links become bodies of their row, moving branches are omitted.
  void addAside(std::size_t row, const Link& link, const Isometry3d& X_LK) {
    for (const auto& child : link.children) {
      if (isOnChain(*child)) continue;
      if (isMoving(*child->joint)) {
        out_.left_out.push_back(sideBranch(*child));
        continue;
      }
      const Isometry3d X = X_LK * child->joint->origin.pose();
      addBody(row, *child, X);
      addAside(row, *child, X);
    }
  }

  /// Records solids fixed to the root as omitted, because no row moves them.
  void leaveOutStanding(const Link& link) {
    if (!link.solids.empty())
      out_.left_out.push_back(
          fmt::format("the solids of link {}, which does not move: write them into the cell's scene", link.name));
    for (const auto& child : link.children) {
      if (isOnChain(*child)) continue;
      if (isMoving(*child->joint))
        out_.left_out.push_back(sideBranch(*child));
      else
        leaveOutStanding(*child);
    }
  }

  static std::string sideBranch(const Link& link) {
    return fmt::format("link {} and the links that it carries: joint {} is not in the chain from the base to the tip",
                       link.name, link.joint->name);
  }

  void addShape(const std::string& row, const UrdfTree::Solid& solid, const Isometry3d& X_LK) {
    const Isometry3d X = X_LK * solid.origin.pose();
    const auto text = [](const Vector3d& v) {
      return fmt::format("[{}, {}, {}]", formatNumber(v.x()), formatNumber(v.y()), formatNumber(v.z()));
    };
    if (solid.kind == "mesh") {
      out_.left_out.push_back(
          fmt::format("the mesh {} of row {}: write it into the cell's link_shapes", solid.file, row));
      return;
    }
    const Vector3d at = X.translation(), half = X.linear().col(2) * solid.size[1] / 2;
    const std::string radius = formatNumber(solid.size[0]);
    out_.shapes.push_back({row, solid.kind == "cylinder" ? fmt::format("cylinder: {{from: {}, to: {}, radius: {}}}",
                                                                       text(at - half), text(at + half), radius)
                                : solid.kind == "sphere"
                                    ? fmt::format("sphere: {{center: {}, radius: {}}}", text(at), radius)
                                    : fmt::format("box: {{center: {}, size: {}, rpy: {}}}", text(at), text(solid.size),
                                                  text(deflection::fixedAnglesOf(X.linear()) / kDegree))});
  }

  const UrdfTree& tree_;
  const std::string& file_;
  UrdfChain links_;
  std::size_t last_moving_ = 0;   ///< number of rows: links up to the last link with a moving joint
  std::vector<Isometry3d> X_LK_;  ///< pose of each link of the chain relative to its row's frame
  bool has_inertia_ = false;
  UrdfArm out_;
};

/// Returns sentences on controller data of the chain's joints that an arm does not contain, one for each kind of data.
std::vector<std::string> leftToControllers(const UrdfChain& chain) {
  using Words = UrdfTree::ControllerWords;
  const struct {
    std::string Words::*words;
    const char *what, *instead;
  } sorts[] = {
      {&Words::soft_limits, "soft limits (safety_controller)", "the arm has the hard ones of <limit>"},
      {&Words::reference_marks, "reference marks (calibration)",
       "readings count from the joint's zero, as the controller shows them"},
      {&Words::transmission, "transmissions", "readings are the joint's, not its motor's"},
  };
  std::vector<std::string> sentences;
  for (const auto& [words, what, instead] : sorts) {
    std::vector<std::string> joints;
    for (const auto& link : chain)
      if (const auto& conventions = link->joint->controller.*words; !conventions.empty())
        joints.push_back(nameInLine(link->joint->name) + conventions);
    if (!joints.empty()) sentences.push_back(fmt::format("{}: {}; {}", what, fmt::join(joints, ", "), instead));
  }
  return sentences;
}

UrdfArm armTo(const UrdfTree& tree, const Link& end, const std::string& file) {
  UrdfArm read = ChainReader(tree, end, file).read();
  const UrdfChain chain = chainTo(tree, end, file);
  read.remarks = remarksOnNumbers(chain);
  std::ranges::move(leftToControllers(chain), std::back_inserter(read.left_out));
  read.left_out.insert(read.left_out.begin(), tree.left_out.begin(), tree.left_out.end());
  const auto problems = deflection::findProblems(read.arm);
  if (!problems.empty())
    throw InputError(fmt::format("{} ({})", file, problems.front().path), problems.front().found,
                     problems.front().expected);
  return read;
}

bool canEndAt(const UrdfTree& tree, const Link& end, const std::string& file) {
  try {
    (void)armTo(tree, end, file);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

UrdfArm parseUrdf(const std::string& text, const std::string& file, const std::string& tip) {
  const UrdfTree tree = readUrdfTree(text, file);
  try {
    return armTo(tree, findTip(tree, tip, file), file);
  } catch (const TipError& error) {
    InputChoice choice = tipChoice(tree, [&](const Link& end) { return canEndAt(tree, end, file); });
    if (choice.values.empty()) throw;
    throw InputQuestion(error, std::move(choice));
  }
}

}  // namespace tubeplan::app
