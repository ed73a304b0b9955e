#include "app/formats/arm/arm_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "app/formats/quantities.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "app/formats/yaml/yaml_edit.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"
#include "deflection/rotation.hpp"
#include "deflection/row_conventions.hpp"
#include "deflection/row_numbers.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

using deflection::Arm;
using deflection::Joint;
using deflection::JointType;
using deflection::RowConvention;
using ArmRow = deflection::Row<double>;

/// Reads the parameters of a row from one of the row's maps, such as "beam" or "dh". Parameters that the map lacks keep
/// their values.
void readNumbers(const YamlNode& node, std::string_view map, const Units& units, ArmRow& row) {
  deflection::visitNumbers(
      [&](const deflection::RowNumber& about, double& number) {
        const std::string key(deflection::keyIn(map, about));
        if (!key.empty()) number = readQuantityOr(node, key, units, dimensionOf(about.quantity), number);
      },
      row);
}

JointType readJointType(const YamlNode& node) {
  const std::string type = node.text();
  if (type == "revolute") return JointType::kRevolute;
  if (type == "prismatic") return JointType::kPrismatic;
  node.fail("revolute or prismatic", "omit `joint` for a fixed row");
}

/// Reads a coupled joint, which follows other joints and has no encoder. The key `follows` is read later, after all
/// rows.
Joint<double> readFollower(const YamlNode& node, const Units& units) {
  node.expectKeys({"name", "type", "follows"}, {"offset"});
  if (readJointType(node.at("type")) != JointType::kRevolute) node.at("type").fail("revolute, for a coupled joint");
  Joint<double> joint;
  joint.name = node.at("name").text();
  joint.offset = readQuantityOr(node, "offset", units, dimension::kAngle, 0);
  return joint;
}

// Reads a joint; max_speed and max_acceleration are per second whatever the file's unit of time.
Joint<double> readJoint(const YamlNode& node, const Units& units) {
  if (node.find("follows")) return readFollower(node, units);
  node.expectKeys({"name", "type"},
                  {"offset", "limits", "max_speed", "max_acceleration", "encoder_sigma", "gear_ratio"});
  Joint<double> joint;
  joint.name = node.at("name").text();
  joint.type = readJointType(node.at("type"));
  const Dimension unit = joint.type == JointType::kPrismatic ? dimension::kLength : dimension::kAngle;
  joint.offset = readQuantityOr(node, "offset", units, unit, 0);
  joint.max_speed = readQuantityOr(node, "max_speed", units, unit, joint.max_speed);
  joint.max_acceleration = readQuantityOr(node, "max_acceleration", units, unit, joint.max_acceleration);
  joint.gear_ratio = readQuantityOr(node, "gear_ratio", units, dimension::kNone, 0);
  joint.encoder_sigma = readQuantityOr(node, "encoder_sigma", units, unit, 0);
  if (const YamlNode* limits = node.find("limits")) {
    const auto& ends = limits->list(2, "a list of two numbers: lowest, highest");
    joint.lower = readQuantity(ends[0], units, unit);
    joint.upper = readQuantity(ends[1], units, unit);
  }
  return joint;
}

// Reads Denavit-Hartenberg parameters. The parameter that the joint itself varies is optional.
void readDh(const YamlNode& node, const Units& units, ArmRow& row) {
  const bool turns = !row.joint.name.empty() && row.joint.type != JointType::kPrismatic;
  std::vector<std::string> required{"alpha", "a"}, optional{"beta", "b"};
  (row.joint.type == JointType::kPrismatic ? optional : required).push_back("d");
  (turns ? optional : required).push_back("theta");
  node.expectKeys(required, optional);
  row.placement = deflection::DenavitHartenberg<double>{};
  readNumbers(node, "dh", units, row);
}

deflection::Origin<double> readOrigin(const YamlNode& node, const Units& units) {
  node.expectKeys({"position", "rpy"}, {"beta"});
  return {readVector(node.at("position"), units, dimension::kLength),
          readVector(node.at("rpy"), units, dimension::kAngle),
          readQuantityOr(node, "beta", units, dimension::kAngle, 0)};
}

void readPlacement(const YamlNode& node, const Units& units, ArmRow& row) {
  const YamlNode* dh = node.find("dh");
  const YamlNode* origin = node.find("origin");
  if (dh && origin) node.failSaying("the row has both `dh` and `origin`", "remove one of them");
  if (!dh && !origin)
    node.failSaying("the row has neither `dh` nor `origin`", "add dh: {alpha, a, d, theta} or origin: {position, rpy}");
  if (dh)
    readDh(*dh, units, row);
  else
    row.placement = readOrigin(*origin, units);
}

// Throws InputError for a beam with second moments of area but without their modulus, or the reverse: it would silently
// be treated as rigid.
void checkBeamKeys(const YamlNode& node) {
  const bool bends = node.find("Ix") || node.find("Iy") || node.find("Iz");
  const bool twists = node.find("J");
  if (bends != (node.find("E") != nullptr))
    node.failSaying(bends ? "the beam has Ix, Iy or Iz but no E" : "the beam has E but no Ix, Iy or Iz",
                    "a beam that bends needs both");
  if (twists != (node.find("G") != nullptr))
    node.failSaying(twists ? "the beam has J but no G" : "the beam has G but no J", "a beam that twists needs both");
  if (!bends && !twists)
    node.failSaying("the beam neither bends nor twists",
                    "write E with Ix, Iy or Iz, or G with J, or leave out `beam` if the link is rigid");
}

void readBeam(const YamlNode& node, const Units& units, ArmRow& row) {
  node.expectKeys({}, {"E", "Ix", "Iy", "Iz", "G", "J", "segments"});
  checkBeamKeys(node);
  row.beam.emplace();
  readNumbers(node, "beam", units, row);
  if (const YamlNode* segments = node.find("segments")) row.beam->segments = segments->integer(1, 1000);
}

void readWeight(const YamlNode& node, const Units& units, ArmRow& row) {
  node.expectKeys({}, {"distributed", "end", "lumps"});
  readNumbers(node, "weight", units, row);
  const YamlNode* lumps = node.find("lumps");
  if (!lumps) return;
  for (const YamlNode& lump : lumps->list()) {
    lump.expectKeys({"weight", "at"}, {});
    row.weight.lumps.push_back({readQuantity(lump.at("weight"), units, dimension::kForce),
                                readVector(lump.at("at"), units, dimension::kLength)});
  }
}

ArmRow readRow(const YamlNode& node, const Units& units) {
  node.expectKeys({"name"}, {"dh", "axis", "origin", "joint", "joint_stiffness", "beam", "weight"});
  ArmRow row;
  row.name = node.at("name").text();
  if (row.name.find_first_of(".[] ") != std::string::npos)
    node.at("name").fail("a name without blanks, dots or brackets");
  if (const YamlNode* joint = node.find("joint")) row.joint = readJoint(*joint, units);
  readPlacement(node, units, row);
  if (const YamlNode* stiffness = node.find("joint_stiffness")) {
    stiffness->expectKeys({}, {"x", "y", "z"});
    readNumbers(*stiffness, "joint_stiffness", units, row);
  }
  if (const YamlNode* beam = node.find("beam")) readBeam(*beam, units, row);
  if (const YamlNode* weight = node.find("weight")) readWeight(*weight, units, row);
  return row;
}

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
      follows.items[k].failSaying(
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
      joint->at("follows").failSaying("a joint of a side chain cannot follow others", "give it a reading of its own");
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
      row.at("origin").failSaying(
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
      axis->failSaying("`axis` is only for a first link with `dh` under `convention: standard`",
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

/// Returns the row with the given name among the links of the arm or of its side chains; null if there is none.
const YamlNode* findRow(const YamlNode& node, std::string_view name) {
  if (const YamlNode* links = node.find("links"))
    for (const YamlNode& row : links->items) {
      const YamlNode* row_name = row.find("name");
      if (row_name && row_name->scalar == name) return &row;
    }
  if (const YamlNode* chains = node.find("side_chains"))
    for (const YamlNode& chain : chains->items)
      if (const YamlNode* row = findRow(chain, name)) return row;
  return nullptr;
}

bool isToolKey(std::string_view rest) { return rest.starts_with("tip") || rest.starts_with("turn") || rest == "axis"; }

// Converts the part of a parameter's dotted name after the row or tool to a path in the file: vector components become
// indices such as [0], and a lump becomes the weight of the lump.
std::string pathBelow(std::string_view rest) {
  constexpr std::string_view kLumps = "weight.lumps.";
  if (rest.starts_with(kLumps))
    return fmt::format("weight.lumps[{}].weight", std::stoi(std::string(rest.substr(kLumps.size()))) - 1);
  const std::size_t dot = rest.rfind('.');
  const std::string_view parent = rest.substr(0, dot == std::string_view::npos ? 0 : dot);
  if (parent == "tip" || parent == "origin.position")
    return fmt::format("{}[{}]", parent, std::string_view("xyz").find(rest.back()));
  if (parent == "origin.rpy") return fmt::format("origin.rpy[{}]", std::string_view("rpy").find(rest.back()));
  return std::string(rest);
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

const YamlNode& findArmNode(const YamlNode& arm, std::string_view name) {
  const std::string path = armPath(arm, name);
  const YamlNode* best = &arm;
  for (std::size_t end = 0; end < path.size(); ++end) {
    if (end + 1 < path.size() && path[end + 1] != '.' && path[end + 1] != '[') continue;
    const std::string_view part = std::string_view(path).substr(0, end + 1);
    if (const YamlNode* node = findNode(arm, part)) best = node;
  }
  return *best;
}

std::string armPath(const YamlNode& arm, std::string_view name) {
  const std::string prefix = arm.path.empty() ? "" : arm.path + ".";
  const std::size_t dot = name.find('.');
  const std::string_view first = name.substr(0, dot);
  const std::string_view rest = dot == std::string_view::npos ? "" : name.substr(dot + 1);
  // A row may also be named `tool`; only the names tip, turn and axis always refer to the arm's tool.
  const YamlNode* row = first == "tool" && isToolKey(rest) ? nullptr : findRow(arm, first);
  if (row) return rest.empty() ? row->path : row->path + "." + pathBelow(rest);
  return arm.find(first) ? prefix + std::string(first) + (rest.empty() ? "" : "." + pathBelow(rest)) : "";
}

std::string withArmParameters(const std::string& text, const YamlNode& arm, const ArmSource& source,
                              const std::vector<std::pair<std::string, double>>& parameters) {
  std::string out = text;
  for (const auto& [name, value] : parameters) {
    const auto parameter = deflection::findParameter(source.arm, name);
    assert(parameter.has_value());
    out = withYamlValue(out, armPath(arm, name),
                        formatNumber(source.units.toFile(value, dimensionOf(parameter->quantity))));
  }
  return out;
}

std::string withoutArmParameters(const std::string& text, const YamlNode& arm, const std::vector<std::string>& names) {
  std::string out = text;
  for (const auto& name : names) out = withoutYamlValue(out, armPath(arm, name));
  return out;
}

}  // namespace tubeplan::app
