#include "app/formats/urdf/urdf_writer.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "app/formats/units.hpp"
#include "deflection/chain.hpp"
#include "deflection/effects/effect.hpp"
#include "deflection/rotation.hpp"
#include "deflection/weights.hpp"

namespace tubeplan::app {

namespace {

using deflection::Arm, deflection::JointType;
using Eigen::Vector3d;
using ArmRow = deflection::Row<double>;

std::string triple(const Vector3d& v) { return fmt::format("{:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z()); }

/// Returns the URDF element `inertial` of a row: its total mass [kg], placed at the centre of mass in the row's frame.
/// Empty if the row has no mass.
std::string inertialText(const deflection::RowWeight& row) {
  if (!(row.weight > 0)) return "";
  return fmt::format(
      "    <inertial>\n      <origin xyz=\"{}\" rpy=\"0 0 0\"/>\n      <mass value=\"{:.17g}\"/>\n"
      "      <inertia ixx=\"0\" ixy=\"0\" ixz=\"0\" iyy=\"0\" iyz=\"0\" izz=\"0\"/>\n    </inertial>\n",
      triple(row.moment_R / row.weight), row.weight / kWeightOfKilogram);
}

/// Returns true if the z axis of the drawn tool frame is the tool axis, to the twelve digits of an arm file.
bool keepsToolFrame(const Arm& arm) { return arm.R_LT.col(2).isApprox(arm.tool_axis_L, 1e-10); }

bool isRead(const ArmRow& row) { return row.joint.encoder_sigma > 0; }

class UrdfWriter {
 public:
  explicit UrdfWriter(const Arm& arm) : arm_(arm) {}

  UrdfText write() {
    const std::string base = unusedName("base"), tip = unusedName("tip");
    text_ = fmt::format("<?xml version=\"1.0\"?>\n<robot name=\"{}\">\n  <link name=\"{}\"/>\n",
                        xmlEscaped(arm_.name.empty() ? "arm" : arm_.name), base);
    std::string parent = base;
    for (std::size_t k = 0; k < arm_.rows.size(); ++k) {
      addRow(k, parent);
      parent = arm_.rows[k].name;
    }
    text_ += fmt::format("  <link name=\"{}\"/>\n", tip);
    addJoint(unusedJoint("tip"), "fixed", parent, tip, arm_.p_LT, urdfTipTurn(arm_), "");
    text_ += "</robot>\n";
    const auto beyond = beyondUrdf(arm_);
    left_out_.insert(left_out_.end(), beyond.begin(), beyond.end());
    return {std::move(text_), std::move(left_out_)};
  }

 private:
  /// Returns a link name that no row has, by appending underscores to `name`.
  [[nodiscard]] std::string unusedName(std::string name) const {
    while (deflection::findRow(arm_, name)) name += '_';
    return name;
  }
  [[nodiscard]] std::string unusedJoint(std::string name) const {
    const auto isTaken = [&](const ArmRow& row) { return row.joint.name == name; };
    while (std::any_of(arm_.rows.begin(), arm_.rows.end(), isTaken)) name += '_';
    return name;
  }

  void addRow(std::size_t k, const std::string& parent) {
    const ArmRow& row = arm_.rows[k];
    text_ += fmt::format("  <link name=\"{}\">\n{}  </link>\n", xmlEscaped(row.name),
                         inertialText(deflection::rowWeightOf(arm_, k)));
    Vector3d position = deflection::offsetInPreviousAxes<double>(row);
    Eigen::Matrix3d turn = deflection::rotationFromPrevious<double>(row);
    const bool slides = row.joint.type == JointType::kPrismatic;
    if (slides) position += turn.col(2) * row.joint.offset;
    if (row.joint.type == JointType::kRevolute) turn = turn * deflection::rotationZ<double>(row.joint.offset);
    const bool is_moving = deflection::turns(row.joint) || slides;
    const std::string name = row.joint.name.empty() ? row.name + "-fixed" : row.joint.name;
    addJoint(name,
             !is_moving             ? "fixed"
             : slides               ? "prismatic"
             : isBounded(row.joint) ? "revolute"
                                    : "continuous",
             parent, row.name, position, turn, is_moving ? limitsText(row.joint) + mimicText(row) : "");
  }

  static bool isBounded(const deflection::Joint<double>& joint) {
    return std::isfinite(joint.lower) && std::isfinite(joint.upper);
  }

  static std::string limitsText(const deflection::Joint<double>& joint) {
    std::string text = "    <axis xyz=\"0 0 1\"/>\n    <limit effort=\"0\"";
    if (isBounded(joint)) text += fmt::format(" lower=\"{:.17g}\" upper=\"{:.17g}\"", joint.lower, joint.upper);
    return text + fmt::format(" velocity=\"{:.17g}\"/>\n", std::isfinite(joint.max_speed) ? joint.max_speed : 0);
  }

  /// Returns the text of `<mimic>` for a joint that follows another joint. URDF refers to the reading of the
  /// followed joint, so the offset of that joint is added here.
  std::string mimicText(const ArmRow& row) {
    if (row.joint.follows.empty()) return "";
    if (row.joint.follows.size() > 1)
      left_out_.push_back("all but the first of the joints that " + row.joint.name + " follows");
    const auto& first = row.joint.follows.front();
    const auto& leader = arm_.rows[static_cast<std::size_t>(first.row)].joint;
    return fmt::format("    <mimic joint=\"{}\" multiplier=\"{:.17g}\" offset=\"{:.17g}\"/>\n", xmlEscaped(leader.name),
                       first.ratio, row.joint.offset + first.ratio * leader.offset);
  }

  void addJoint(const std::string& name, const char* type, const std::string& parent, const std::string& child,
                const Vector3d& position, const Eigen::Matrix3d& turn, const std::string& more) {
    text_ += fmt::format(
        "  <joint name=\"{}\" type=\"{}\">\n    <origin xyz=\"{}\" rpy=\"{}\"/>\n    <parent link=\"{}\"/>\n"
        "    <child link=\"{}\"/>\n{}  </joint>\n",
        xmlEscaped(name), type, triple(position), triple(deflection::fixedAnglesOf(turn)), xmlEscaped(parent),
        xmlEscaped(child), more);
  }

  const Arm& arm_;
  std::string text_;
  std::vector<std::string> left_out_;
};

}  // namespace

std::string xmlEscaped(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
  return out;
}

Eigen::Matrix3d urdfTipTurn(const Arm& arm) {
  if (keepsToolFrame(arm)) return toolFrame(arm);
  return Eigen::Quaterniond::FromTwoVectors(arm.R_LT.col(2), arm.tool_axis_L) * arm.R_LT;
}

std::vector<std::string> beyondUrdf(const Arm& arm) {
  std::vector<std::string> sentences;
  const auto add = [&](bool is_there, const char* sentence) {
    if (is_there) sentences.emplace_back(sentence);
  };
  add(std::ranges::any_of(arm.rows, deflection::isCompliant), "stiffnesses and beams: URDF's links are rigid");
  add(!keepsToolFrame(arm), "the tool frame's turn (rpy): the exported tip's z is the tool's axis");
  add(keepsToolFrame(arm) && !arm.tool_turn_L.isZero(0),
      "the tool's axis, which differs from its frame: z of the exported tip is z of the frame, by `turn`");
  add(!arm.gravity_W.isApprox(-Vector3d::UnitZ(), 1e-12),
      "the direction of gravity: URDF has none, and an imported arm has gravity along -z");
  add(std::ranges::any_of(arm.rows, isRead), "the encoders' noise: URDF has no place for it");
  add(!arm.side_chains.empty(), "side chains: only a serial chain can be imported again");
  for (const auto& effect : arm.effects)
    sentences.push_back(fmt::format("the effect {}: URDF has no place for it", deflection::textOf(arm, effect)));
  return sentences;
}

UrdfText urdfOf(const Arm& arm) { return UrdfWriter(arm).write(); }

}  // namespace tubeplan::app
