#include "app/documents/arm_figures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <variant>

#include "app/documents/figures.hpp"
#include "app/documents/figures_text.hpp"
#include "app/formats/units_json.hpp"
#include "deflection/effects/rigid_frames.hpp"
#include "deflection/weights.hpp"

namespace tubeplan::app {

namespace {

using deflection::Arm, deflection::JointType;
using Eigen::Vector3d, Eigen::VectorXd;

/// Sets to zero each coordinate that is only a rounding error relative to the length `size`.
void clean(Vector3d& p, double size) {
  for (double& x : p)
    if (std::abs(x) < 1e-12 * size) x = 0;
}

deflection::RigidFrames<double> framesAtZero(const Arm& arm) {
  const auto joints = arm.jointCount();
  auto frames = deflection::rigidFramesOf<double>(arm, VectorXd::Zero(joints));
  const double reach = deflection::reachOf(arm);
  for (auto& row : frames.rows) clean(row.p, reach);
  clean(frames.tip, reach);
  return frames;
}

std::string typeOf(const deflection::Joint<double>& joint) {
  if (!joint.follows.empty()) return "follows";
  return joint.type == JointType::kPassive ? "fixed" : joint.type == JointType::kRevolute ? "revolute" : "prismatic";
}

/// Returns the flexible parts of a row, such as "joint z, beam"; empty for a rigid row.
std::string complianceOf(const deflection::Row<double>& row) {
  std::string axes;
  for (int k = 0; k < 3; ++k)
    if (std::isfinite(row.joint_stiffness[k])) axes += "xyz"[k];
  std::string text = axes.empty() ? "" : "joint " + axes;
  if (row.beam) text += text.empty() ? "beam" : ", beam";
  return text;
}

std::string limitsOf(const deflection::Joint<double>& joint, const Units& units) {
  if (joint.type == JointType::kPassive || !std::isfinite(joint.lower) || !std::isfinite(joint.upper)) return "";
  const Dimension unit = joint.type == JointType::kPrismatic ? dimension::kLength : dimension::kAngle;
  return fmt::format("{:.5g} to {:.5g} {}", units.toFile(joint.lower, unit), units.toFile(joint.upper, unit),
                     units.nameOf(unit));
}

nlohmann::json originJson(const deflection::Row<double>& row, const Units& units) {
  const auto* origin = std::get_if<deflection::Origin<double>>(&row.placement);
  if (!origin) return nullptr;
  return {{"position", vectorJson(origin->position, units, dimension::kLength)},
          {"rpy", vectorJson(origin->rpy, units, dimension::kAngle)},
          {"beta", units.toFile(origin->beta, dimension::kAngle)}};
}

constexpr TextLine kOriginWords[] = {{"+beta", ", beta {}"}, {"-beta", ", beta {}"}, {"", " {units/angle}\n"}};

constexpr TextLine kArmWords[] = {
    {"name", "{}"},
    {"!name", "arm"},
    {"",
     ": {joints} joints, reaches {reach:.4r units/length}, weighs {weight:.4r units/force}\n"
     "  row                    joint        type          origin, joints at zero               limits     weight  "
     "compliant\n"},
    {"rows",
     "  {name:<22} {joint:<12} {type:<9} {position:>22.4r units/length} {limits:>20} {weight:>6.4r units/force}  "
     "{compliant}\n"},
    {"rows/origin", "  origin of {name}: position {position} {units/length}, rpy {rpy}", kOriginWords},
    {"", "  tip at {tip:.4r units/length}\n"}};

}  // namespace

nlohmann::json armJson(const Arm& arm, const Units& units) {
  const auto frames = framesAtZero(arm);
  nlohmann::json rows = nlohmann::json::array();
  for (std::size_t k = 0; k < arm.rows.size(); ++k) {
    const auto& row = arm.rows[k];
    const double weight = deflection::rowWeightOf(arm, k).weight;
    const Vector3d z = frames.rows[k].R.col(2);
    rows.push_back({{"name", row.name},
                    {"joint", row.joint.name},
                    {"type", typeOf(row.joint)},
                    {"position", vectorJson(frames.rows[k].p, units, dimension::kLength)},
                    {"origin", originJson(row, units)},
                    {"z_axis", {rounded(z.x()), rounded(z.y()), rounded(z.z())}},
                    {"limits", limitsOf(row.joint, units)},
                    {"compliant", complianceOf(row)},
                    {"weight", units.toFile(weight, dimension::kForce)}});
  }
  return {{"name", arm.name},
          {"joints", arm.jointCount()},
          {"reach", lengthOf(deflection::reachOf(arm), units)},
          {"weight", units.toFile(deflection::weightOf(arm), dimension::kForce)},
          {"rows", rows},
          {"tip", vectorJson(frames.tip, units, dimension::kLength)},
          {"units", unitsJson(units)}};
}

std::string armText(const Arm& arm, const Units& units) { return textOf(armJson(arm, units), kArmWords); }

}  // namespace tubeplan::app
