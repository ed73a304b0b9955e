// Checks an arm for problems before it is used in computations.
#include <cmath>
#include <set>
#include <string>

#include "deflection/arm.hpp"
#include "deflection/effects/effect.hpp"
#include "deflection/parameters.hpp"
#include "deflection/row_numbers.hpp"

namespace tubeplan::deflection {

namespace {

std::string text(double x) {
  std::string s = std::to_string(x);
  return s;
}

constexpr const char* kAxis[3] = {"x", "y", "z"};
constexpr const char* kInertia[3] = {"Ix", "Iy", "Iz"};

void checkNumbers(const Row<double>& row, std::vector<ArmProblem>& out) {
  Row<double> copy = row;
  for (const auto& field : parameterFields()) {
    if (field.of_tool) continue;
    const int lumps = field.of_lump ? static_cast<int>(row.weight.lumps.size()) : 1;
    for (int lump = 0; lump < lumps; ++lump) {
      const double* number = findNumber(copy, field, lump);
      if (!number) continue;
      const std::string path = nameInFile(row, field.name);
      const bool may_be_rigid = isStiffness(field.quantity);
      if (std::isnan(*number) || (std::isinf(*number) && !may_be_rigid))
        out.push_back({path, text(*number), "a finite number"});
      else if (*number < field.lower || *number > field.upper || (may_be_rigid && *number <= 0))
        out.push_back(
            {path, *number <= 0 ? (*number < 0 ? "a negative number" : "zero") : text(*number),
             may_be_rigid ? "more than zero (leave out the axis if it is rigid)" : "a value in its physical range"});
    }
  }
}

void checkName(const Row<double>& row, std::set<std::string>& rows, std::set<std::string>& joints,
               std::vector<ArmProblem>& out) {
  if (!rows.insert(row.name).second) out.push_back({row.name, "another row has the same name"});
  if (row.joint.type != JointType::kPassive && !joints.insert(row.joint.name).second)
    out.push_back({row.name + ".joint.name", "another joint also has the name '" + row.joint.name + "'"});
}

void checkJoint(const Row<double>& row, std::vector<ArmProblem>& out) {
  const auto& joint = row.joint;
  const std::string path = row.name + ".joint";
  if (!(joint.lower < joint.upper))
    out.push_back(
        {path + ".limits", text(joint.lower) + ", " + text(joint.upper), "a lower limit below the upper one"});
  if (!(joint.max_speed > 0)) out.push_back({path + ".max_speed", text(joint.max_speed), "more than zero"});
  if (!(joint.max_acceleration > 0))
    out.push_back({path + ".max_acceleration", text(joint.max_acceleration), "more than zero"});
  if (!(joint.gear_ratio >= 0 && std::isfinite(joint.gear_ratio)))
    out.push_back({path + ".gear_ratio", text(joint.gear_ratio), "zero or more"});
  if (!(joint.encoder_sigma >= 0)) out.push_back({path + ".encoder_sigma", text(joint.encoder_sigma), "zero or more"});
}

void checkFollower(const Arm& arm, const Row<double>& row, std::vector<ArmProblem>& out) {
  const std::string path = row.name + ".joint.follows";
  for (const auto& followed : row.joint.follows) {
    if (followed.row < 0 || arm.rows.at(static_cast<std::size_t>(followed.row)).joint.type != JointType::kRevolute)
      out.push_back({path, "the followed joint is not revolute, or has no encoder reading of its own"});
    if (!std::isfinite(followed.ratio)) out.push_back({path, text(followed.ratio), "a finite number"});
  }
}

void checkBeam(const Arm& arm, int index, std::vector<ArmProblem>& out) {
  const Row<double>& row = arm.rows[index];
  if (!row.beam) return;
  const std::string path = row.name + ".beam";
  if (row.beam->segments < 1 || row.beam->segments > 1000)
    out.push_back({path + ".segments", std::to_string(row.beam->segments), "1 to 1000"});
  const Eigen::Vector3d member = undeflectedMember(arm, index);
  if (member.norm() < 1e-9) {
    out.push_back({path, "the flexible member has length zero: the next row (or the tip) is at this row's origin"});
    return;
  }
  for (int k = 0; k < 3; ++k)
    if (std::isfinite(row.beam->I[k]) && std::abs(member.normalized()[k]) > 1 - 1e-9)
      out.push_back({path + "." + kInertia[k], std::string("a member does not bend about its own axis, here ") +
                                                   kAxis[k] + ": give G and J for the twist about this axis"});
}

/// Checks a row of a side chain: it must be rigid, and its joint must not follow others.
void checkSideRow(const Row<double>& row, std::vector<ArmProblem>& out) {
  if (row.beam || row.joint_stiffness.array().isFinite().any())
    out.push_back({row.name, "a row of a side chain must be rigid, without beam and joint_stiffness"});
  if (!row.joint.follows.empty())
    out.push_back({row.name + ".joint.follows", "a joint of a side chain cannot follow others"});
}

double weightOf(const Row<double>& row) {
  double weight = row.weight.distributed + row.weight.end;
  for (const auto& lump : row.weight.lumps) weight += lump.weight;
  return weight;
}

void checkSideChains(const Arm& arm, std::set<std::string>& rows, std::set<std::string>& joints,
                     std::vector<ArmProblem>& out) {
  for (const auto& chain : arm.side_chains) {
    double weight = 0;
    for (const auto& row : chain.rows) {
      checkName(row, rows, joints, out);
      checkNumbers(row, out);
      if (row.joint.type != JointType::kPassive) checkJoint(row, out);
      checkSideRow(row, out);
      weight += weightOf(row);
    }
    if (!chain.rows.empty() && weight == 0)
      out.push_back(
          {chain.rows.front().name, "the side chain has no weight, which is the only influence that it can have"});
  }
}

}  // namespace

std::vector<ArmProblem> findProblems(const Arm& arm) {
  std::vector<ArmProblem> out;
  if (arm.rows.empty()) out.push_back({"links", "no rows", "at least one row"});
  std::set<std::string> rows, joints;
  for (int i = 0; i < static_cast<int>(arm.rows.size()); ++i) {
    const Row<double>& row = arm.rows[i];
    checkName(row, rows, joints, out);
    checkNumbers(row, out);
    if (row.joint.type != JointType::kPassive) checkJoint(row, out);
    checkFollower(arm, row, out);
    checkBeam(arm, i, out);
  }
  if (joints.empty()) out.push_back({"links", "no joint", "at least one revolute or prismatic row"});
  checkSideChains(arm, rows, joints, out);
  if (!arm.p_LT.allFinite()) out.push_back({"tool.tip", "a number that is not finite", "three finite lengths"});
  if (std::abs(arm.gravity_W.norm() - 1) > 1e-9)
    out.push_back({"gravity", "a direction of length zero", "three numbers, not all zero"});
  if (std::abs(arm.tool_axis_L.norm() - 1) > 1e-9)
    out.push_back({"tool.axis", "a direction of length zero", "three numbers, not all zero"});
  if (!((arm.R_LT.transpose() * arm.R_LT - Eigen::Matrix3d::Identity()).norm() < 1e-9))
    out.push_back({"tool.rpy", "axes that do not form a frame", "three finite angles"});
  if (!arm.tool_turn_L.allFinite()) out.push_back({"tool.turn", "a number that is not finite", "three finite angles"});
  for (auto& problem : findEffectProblems(arm)) out.push_back(std::move(problem));
  return out;
}

}  // namespace tubeplan::deflection
