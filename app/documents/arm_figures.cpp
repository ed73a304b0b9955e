#include "app/documents/arm_figures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <variant>

#include "app/documents/figures.hpp"
#include "app/files/units_json.hpp"
#include "deflection/effects/rigid_frames.hpp"
#include "deflection/weights.hpp"

namespace tubeplan::app {

namespace {

using deflection::Arm, deflection::JointType;
using Eigen::Vector3d, Eigen::VectorXd;

/// What rounding alone leaves of a zero is shown as one.
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

/// "joint z, beam": where a row gives.
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

/// Three numbers as a file in these units has them: "0, 90, 180".
std::string numbersInFile(const Vector3d& values, const Units& units, Dimension unit) {
  return fmt::format("{}, {}, {}", formatNumber(units.toFile(values.x(), unit)),
                     formatNumber(units.toFile(values.y(), unit)), formatNumber(units.toFile(values.z(), unit)));
}

/// Where a row by origin is placed by the row before, as its file has it; empty for a row by dh.
std::string originText(const deflection::Row<double>& row, const Units& units) {
  const auto* origin = std::get_if<deflection::Origin<double>>(&row.placement);
  if (!origin) return "";
  const std::string beta =
      origin->beta == 0 ? "" : fmt::format(", beta {}", formatNumber(units.toFile(origin->beta, dimension::kAngle)));
  return fmt::format("position {} {}, rpy {}{} {}", numbersInFile(origin->position, units, dimension::kLength),
                     units.length().name, numbersInFile(origin->rpy, units, dimension::kAngle), beta,
                     units.nameOf(dimension::kAngle));
}

nlohmann::json originJson(const deflection::Row<double>& row, const Units& units) {
  const auto* origin = std::get_if<deflection::Origin<double>>(&row.placement);
  if (!origin) return nullptr;
  return {{"position", vectorJson(origin->position, units, dimension::kLength)},
          {"rpy", vectorJson(origin->rpy, units, dimension::kAngle)},
          {"beta", units.toFile(origin->beta, dimension::kAngle)}};
}

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

std::string armText(const Arm& arm, const Units& units) {
  const nlohmann::json json = armJson(arm, units);
  const auto length = units.length().name, force = units.force().name;
  std::string text =
      fmt::format("{}: {} joints, reaches {:.4g} {}, weighs {:.4g} {}\n", arm.name.empty() ? "arm" : arm.name,
                  json["joints"].get<int>(), json["reach"].get<double>(), length, json["weight"].get<double>(), force);
  text += fmt::format("  {:<22} {:<12} {:<9} {:>30} {:>20} {:>10}  {}\n", "row", "joint", "type",
                      fmt::format("origin, joints at zero ({})", length), "limits", fmt::format("weight ({})", force),
                      "compliant");
  for (const auto& row : json["rows"]) {
    const auto& p = row["position"];
    text +=
        fmt::format("  {:<22} {:<12} {:<9} {:>30} {:>20} {:>10.4g}  {}\n", row["name"].get<std::string>(),
                    row["joint"].get<std::string>(), row["type"].get<std::string>(),
                    fmt::format("{:.4g}, {:.4g}, {:.4g}", p[0].get<double>(), p[1].get<double>(), p[2].get<double>()),
                    row["limits"].get<std::string>(), row["weight"].get<double>(), row["compliant"].get<std::string>());
  }
  for (const auto& row : arm.rows)
    if (const std::string origin = originText(row, units); !origin.empty())
      text += fmt::format("  origin of {}: {}\n", row.name, origin);
  const auto& tip = json["tip"];
  return text + fmt::format("  tip at {:.4g}, {:.4g}, {:.4g} {}\n", tip[0].get<double>(), tip[1].get<double>(),
                            tip[2].get<double>(), length);
}

}  // namespace tubeplan::app
