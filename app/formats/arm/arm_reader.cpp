#include "app/formats/arm/arm_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/formats/arm/arm_numbers.hpp"
#include "app/formats/arm/row_reader.hpp"
#include "app/formats/quantities.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"
#include "deflection/rotation.hpp"
#include "deflection/row_conventions.hpp"
#include "deflection/row_numbers.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

using deflection::Arm;
using deflection::JointType;
using deflection::RowConvention;
using ArmRow = deflection::Row<double>;

/// Reads the joints that a coupled joint follows, from a map of joint names to ratios.
std::vector<deflection::FollowedJoint> readFollowed(const YamlNode& follows, const Arm& arm) {
  if (follows.kind != YamlNode::Kind::kMap || follows.keys.empty())
    follows.fail("one or more entries JOINT: RATIO, such as {theta1: -1}");
  std::vector<deflection::FollowedJoint> followed;
  for (std::size_t k = 0; k < follows.keys.size(); ++k) {
    const auto row = std::find_if(arm.rows.begin(), arm.rows.end(), [&](const ArmRow& candidate) {
      return candidate.joint.type == JointType::kRevolute && candidate.joint.name == follows.keys[k];
    });
    if (row == arm.rows.end())
      follows.items[k].failWithProblem(
          inQuotes(follows.keys[k]) + " is not a revolute joint with an encoder reading of its own",
          "write JOINT: RATIO, such as {theta1: -1}");
    followed.push_back({static_cast<int>(row - arm.rows.begin()), follows.items[k].number()});
  }
  return followed;
}

deflection::SideChain<double> readSideChain(const YamlNode& node, const Units& units, const Arm& arm) {
  node.expectKeys({"on", "links"}, {});
  const YamlNode& on = node.at("on");
  const auto names = deflection::rowNames(arm);
  const auto carrier = deflection::findRow(arm, on.text());
  if (!carrier) on.fail("the unknown link " + inQuotes(on.text()), alternatives(names), suggestion(on.text(), names));
  deflection::SideChain<double> chain{*carrier, {}};
  for (const YamlNode& row : node.at("links").list()) {
    chain.rows.push_back(readRow(row, units));
    if (const YamlNode* joint = row.find("joint"); joint && joint->find("follows"))
      joint->at("follows").failWithProblem("a joint of a side chain cannot follow others",
                                           "give it a reading of its own");
  }
  if (chain.rows.empty()) node.at("links").fail("one or more links");
  return chain;
}

RowConvention readConvention(const YamlNode& node) {
  const YamlNode* convention = node.find("convention");
  if (!convention || convention->text() == "modified") return RowConvention::kModified;
  if (convention->text() != "standard")
    convention->fail(inQuotes(convention->text()), "standard or modified",
                     "the convention defines the meaning of `dh` in the links; the default is modified (Craig's)");
  return RowConvention::kStandard;
}

/// Throws InputError for a row with `origin` after a row with `dh`: under the standard convention the `dh` row needs
/// alpha and a of the next row, which an origin does not have.
void requireOriginsFirst(const YamlNode& links) {
  bool is_after_dh = false;
  for (const YamlNode& row : links.list()) {
    if (is_after_dh && row.find("origin"))
      row.at("origin").failWithProblem(
          "a row with `origin` follows a row with `dh`, which `convention: standard` does not allow",
          "write this row with `dh`, or convert all rows with `tubeplan arm export --convention`");
    is_after_dh = is_after_dh || row.find("dh");
  }
}

/// Reads the pose of the first axis relative to the frame before it, which a standard Denavit-Hartenberg table does not
/// contain.
void readAxis(const YamlNode& node, const Units& units, deflection::DenavitHartenberg<double>& dh) {
  node.expectKeys({}, {"alpha", "a", "beta", "b"});
  dh.alpha = readQuantityOr(node, "alpha", units, dimension::kAngle, 0);
  dh.a = readQuantityOr(node, "a", units, dimension::kLength, 0);
  dh.beta = readQuantityOr(node, "beta", units, dimension::kAngle, 0);
  dh.b = readQuantityOr(node, "b", units, dimension::kLength, 0);
}

/// Converts the rows of an arm or a side chain from the Denavit-Hartenberg convention that the file states, and reads
/// the axis of the first row.
void takeRows(const YamlNode& links, RowConvention convention, const Units& units, std::vector<ArmRow>& rows) {
  const bool is_standard = convention == RowConvention::kStandard;
  if (is_standard) {
    requireOriginsFirst(links);
    deflection::readAsStandard(rows);
  }
  for (std::size_t k = 0; k < links.items.size(); ++k) {
    const YamlNode* axis = links.items[k].find("axis");
    if (!axis) continue;
    auto* dh = is_standard && k == 0 ? deflection::dhOf(rows[k]) : nullptr;
    if (!dh)
      axis->failWithProblem("`axis` is only for a first link with `dh` under `convention: standard`",
                            "remove it: the axis of any other link follows from its other numbers");
    readAxis(*axis, units, *dh);
  }
}

void readTool(const YamlNode& node, ArmSource& source) {
  node.expectKeys({"tip"}, {"axis", "rpy", "turn"});
  source.arm.p_LT = readVector(node.at("tip"), source.units, dimension::kLength);
  const YamlNode* axis = node.find("axis");
  source.names_tool_axis = axis != nullptr;
  if (axis) source.arm.tool_axis_L = readDirection(*axis);
  if (const YamlNode* rpy = node.find("rpy"))
    source.arm.R_LT = deflection::rotationFromFixedAngles<double>(readVector(*rpy, source.units, dimension::kAngle));
  if (const YamlNode* turn = node.find("turn")) {
    turn->expectKeys({}, {"x", "y", "z"});
    for (const char* axis_name : {"x", "y", "z"})
      source.arm.tool_turn_L[*axis_name - 'x'] = readQuantityOr(*turn, axis_name, source.units, dimension::kAngle, 0);
  }
}

/// Returns the value at a node as the user wrote it, because messages of the library deflection are in internal units.
std::string asWritten(const std::string& found, const YamlNode& at) {
  const auto isScalar = [](const YamlNode& node) { return node.kind == YamlNode::Kind::kScalar; };
  if (at.kind == YamlNode::Kind::kList && at.items.size() == 2 &&
      std::all_of(at.items.begin(), at.items.end(), isScalar))
    return at.items[0].scalar + ", " + at.items[1].scalar;
  if (!isScalar(at)) return found;
  if (tubesheets::parseNumber(found)) return at.scalar;
  return found.find(at.scalar) == std::string::npos ? found + " (" + at.scalar + ")" : found;
}

void checkArm(const YamlNode& node, const Arm& arm) {
  const auto problems = deflection::findProblems(arm);
  if (problems.empty()) return;
  const deflection::ArmProblem& first = problems.front();
  const YamlNode& at = findArmNode(node, first.path);
  throw InputError(at.where(first.path), first.expected.empty() ? first.found : asWritten(first.found, at),
                   first.expected);
}

}  // namespace

std::string referenceKey(const deflection::ConditionKind& kind) { return std::string("reference_") + kind.name; }

ArmSource readArm(const YamlNode& node) {
  std::vector<std::string> optional = {"name", "convention", "gravity", "side_chains", "pair"};
  for (const auto& kind : deflection::kConditionKinds)
    if (kind.is_of_drawing) optional.push_back(referenceKey(kind));
  node.expectKeys({"units", "links", "tool"}, optional);
  ArmSource source;
  source.units = Units(node.at("units"));
  Arm& arm = source.arm;
  if (const YamlNode* name = node.find("name")) arm.name = name->text();
  if (const YamlNode* pair = node.find("pair")) source.pair = pair->text();
  if (const YamlNode* gravity = node.find("gravity")) arm.gravity_W = readDirection(*gravity);
  for (const auto& kind : deflection::kConditionKinds)
    if (const YamlNode* reference = kind.is_of_drawing ? node.find(referenceKey(kind)) : nullptr)
      arm.reference[kind.condition] = source.units.toInternal(reference->number(), kind.unit);
  for (const YamlNode& row : node.at("links").list()) arm.rows.push_back(readRow(row, source.units));
  for (std::size_t k = 0; k < arm.rows.size(); ++k) {
    const YamlNode* joint = node.at("links").items[k].find("joint");
    if (const YamlNode* follows = joint ? joint->find("follows") : nullptr)
      arm.rows[k].joint.follows = readFollowed(*follows, arm);
  }
  if (const YamlNode* chains = node.find("side_chains"))
    for (const YamlNode& chain : chains->list()) arm.side_chains.push_back(readSideChain(chain, source.units, arm));
  const RowConvention convention = readConvention(node);
  takeRows(node.at("links"), convention, source.units, arm.rows);
  for (std::size_t k = 0; k < arm.side_chains.size(); ++k)
    takeRows(node.at("side_chains").items[k].at("links"), convention, source.units, arm.side_chains[k].rows);
  readTool(node.at("tool"), source);
  checkArm(node, arm);
  return source;
}

}  // namespace tubeplan::app
