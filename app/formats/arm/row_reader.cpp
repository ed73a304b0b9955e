#include "app/formats/arm/row_reader.hpp"

#include <string>
#include <vector>

#include "app/formats/quantities.hpp"
#include "deflection/row_numbers.hpp"

namespace tubeplan::app {

namespace {

using deflection::Joint;
using deflection::JointType;
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
  if (dh && origin) node.failWithProblem("the row has both `dh` and `origin`", "remove one of them");
  if (!dh && !origin)
    node.failWithProblem("the row has neither `dh` nor `origin`",
                         "add dh: {alpha, a, d, theta} or origin: {position, rpy}");
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
    node.failWithProblem(bends ? "the beam has Ix, Iy or Iz but no E" : "the beam has E but no Ix, Iy or Iz",
                         "a beam that bends needs both");
  if (twists != (node.find("G") != nullptr))
    node.failWithProblem(twists ? "the beam has J but no G" : "the beam has G but no J",
                         "a beam that twists needs both");
  if (!bends && !twists)
    node.failWithProblem("the beam neither bends nor twists",
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

}  // namespace

deflection::Row<double> readRow(const YamlNode& node, const Units& units) {
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

}  // namespace tubeplan::app
