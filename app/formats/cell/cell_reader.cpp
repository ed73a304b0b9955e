#include "app/formats/cell/cell_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "app/formats/cell/effects_reader.hpp"
#include "app/formats/cell/priors_reader.hpp"
#include "app/formats/cell/scene_reader.hpp"
#include "app/formats/cell/uncertainty_reader.hpp"
#include "app/formats/quantities.hpp"
#include "app/formats/sheet/sheet_reader.hpp"
#include "app/formats/sheet/touched_base.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"
#include "deflection/rotation.hpp"
#include "planner/scene/shape.hpp"

namespace tubeplan::app {

namespace {

// Reads a 6 x 6 covariance in file units: lengths for the first three coordinates, angles for the last three.
Matrix6d readCovariance(const YamlNode& node, const Units& units) {
  Matrix6d covariance;
  const auto scale = [&](int i) { return units.factor(i < 3 ? dimension::kLength : dimension::kAngle); };
  const auto& rows = node.list(6, "six lists of six numbers");
  for (int i = 0; i < 6; ++i) {
    const auto& numbers = rows[static_cast<std::size_t>(i)].list(6, "six numbers");
    for (int j = 0; j < 6; ++j) covariance(i, j) = numbers[static_cast<std::size_t>(j)].number() * scale(i) * scale(j);
  }
  const Eigen::VectorXd sigma = covariance.diagonal().cwiseMax(1e-300).cwiseSqrt();
  const Matrix6d correlation = sigma.cwiseInverse().asDiagonal() * covariance * sigma.cwiseInverse().asDiagonal();
  if (!correlation.isApprox(correlation.transpose(), 1e-6))
    node.failWithProblem("the covariance is not symmetric", "write a symmetric matrix, as six lists of six numbers");
  if (correlation.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff() < -1e-6)
    node.failWithProblem("the matrix has a negative variance, so it is not a covariance matrix",
                         "check its values and their order");
  return covariance;
}

double readSigma(const YamlNode& node, const char* key, const Units& units, Dimension dimension, double otherwise) {
  const YamlNode* value = node.find(key);
  if (!value) return otherwise;
  const double sigma = readQuantity(*value, units, dimension);
  if (!(sigma > 0)) value->fail("a standard deviation above zero");
  return sigma;
}

void readBase(const YamlNode& node, Cell& cell) {
  node.expectKeys({"position", "rpy", "known"}, {"covariance", "prior"});
  cell.X_WB.translation() = readVector(node.at("position"), cell.units, dimension::kLength);
  cell.X_WB.linear() =
      deflection::rotationFromFixedAngles<double>(readVector(node.at("rpy"), cell.units, dimension::kAngle));
  cell.base_known = node.at("known").boolean();
  if (const YamlNode* covariance = node.find("covariance"))
    cell.base_covariance = readCovariance(*covariance, cell.units);
  if (const YamlNode* prior = node.find("prior")) {
    prior->expectKeys({}, {"shift", "turn"});
    cell.base_prior.shift = readSigma(*prior, "shift", cell.units, dimension::kLength, cell.base_prior.shift);
    cell.base_prior.turn = readSigma(*prior, "turn", cell.units, dimension::kAngle, cell.base_prior.turn);
  }
}

// Reads the model error: a length, or a map that also states the source of the value.
void readModelError(const YamlNode& node, Cell& cell) {
  ModelError error;
  const bool is_map = node.kind == YamlNode::Kind::kMap;
  if (is_map) {
    node.expectKeys({"sigma"}, {"degrees_of_freedom", "from"});
    if (const YamlNode* freedom = node.find("degrees_of_freedom"))
      error.degrees_of_freedom = freedom->integer(1, 1000000);
    if (const YamlNode* from = node.find("from")) error.from = from->text();
  }
  const YamlNode& sigma = is_map ? node.at("sigma") : node;
  error.sigma = readQuantity(sigma, cell.units, dimension::kLength);
  if (!(error.sigma >= 0)) sigma.fail("a length of zero or more");
  cell.model_error = error;
}

// Reads the park posture, in the file's unit of angle, or of length for prismatic joints.
void readPark(const YamlNode& node, Cell& cell) {
  const auto& numbers =
      node.list(cell.arm.jointCount(), fmt::format("{} numbers, one for each joint", cell.arm.jointCount()));
  cell.park.emplace(cell.arm.jointCount());
  for (Eigen::Index k = 0; k < cell.arm.jointCount(); ++k) {
    const auto& joint = cell.arm.joint(k);
    const bool slides = joint.type == deflection::JointType::kPrismatic;
    const Dimension unit = slides ? dimension::kLength : dimension::kAngle;
    const double q = readQuantity(numbers[k], cell.units, unit);
    if (!(q >= joint.lower && q <= joint.upper))
      numbers[k].fail(fmt::format("a reading between the limits of {}, {} and {}", joint.name,
                                  formatNumber(cell.units.toFile(joint.lower, unit)),
                                  formatNumber(cell.units.toFile(joint.upper, unit))));
    (*cell.park)[k] = q;
  }
}

/// Returns advice for an unknown row name: a similar name, otherwise all rows of the arm.
std::string adviceOnRow(const std::string& name, const deflection::Arm& arm) {
  const auto rows = deflection::rowNames(arm);
  return suggestionOr(name, rows, fmt::format("its rows are {}", fmt::join(rows, ", ")));
}

// Reads the set-ups of the base that differ from the arm's file: each lists the rows that are rigid in this set-up, for
// example because the arm is on a bench.
void readSetups(const YamlNode& node, deflection::Arm& arm) {
  if (node.kind != YamlNode::Kind::kMap) node.fail("SETUP: {rigid: [rows]} for each set-up");
  for (std::size_t k = 0; k < node.items.size(); ++k) {
    const YamlNode& setup = node.items[k];
    setup.expectKeys({"rigid"}, {});
    deflection::RigidMounting mounting{node.keys[k], {}};
    for (const YamlNode& item : setup.at("rigid").list()) {
      const auto row = deflection::findRow(arm, item.text());
      if (!row) item.failWithProblem("the arm has no row " + inQuotes(item.text()), adviceOnRow(item.text(), arm));
      mounting.rows.push_back(*row);
    }
    arm.mountings.push_back(std::move(mounting));
  }
}

void readIdentify(const YamlNode& node, Cell& cell) {
  const auto known = calibration::freeableNames(cell.arm);
  for (const YamlNode& item : node.list()) {
    const std::string name = item.text();
    if (std::find(known.begin(), known.end(), name) == known.end())
      item.fail("the unknown parameter '" + name + "'", "the path of a number in the arm file, or geometry",
                suggestion(name, known));
    if (std::find(cell.identify.begin(), cell.identify.end(), name) != cell.identify.end())
      item.failWithProblem(inQuotes(name) + " is listed twice", "list each name only once");
    cell.identify.push_back(name);
  }
}

/// Throws InputError if a cell and an arm that were written together have different pair identifiers, which means that
/// one of the two files was replaced. Manual edits do not change the identifier.
void requireSamePair(const YamlNode& pair, const ArmSource& arm, const Cell& cell) {
  if (pair.text() == arm.pair) return;
  const std::string found = arm.pair.empty() ? "none" : "'" + arm.pair + "'";
  pair.failWithProblem(
      fmt::format("'{}' is not the arm file that was written with this cell: the cell has the pair '{}', "
                  "but the arm has {}",
                  cell.arm_path, pair.text(), found),
      "write both again, or remove the key `pair` if another arm is meant");
}

// Reads the arm from the cell itself, from `text` if it is given, or from the arm's own file.
ArmSource readCellArm(const YamlNode& node, const std::optional<std::string>& text, Cell& cell) {
  cell.arm_path = cell.path;
  if (node.kind == YamlNode::Kind::kMap) return readArm(node);
  const auto folder = std::filesystem::path(cell.path).parent_path();
  cell.arm_path = (folder / node.text()).lexically_normal().string();
  if (text) {
    cell.arm_source = {cell.arm_path, *text, parseYaml(*text, cell.arm_path)};
    return readArm(cell.arm_source.root);
  }
  if (std::error_code error; !std::filesystem::exists(cell.arm_path, error))
    node.failWithProblem("there is no file '" + cell.arm_path + "'",
                         "check the name of the arm file, which is relative to this cell's folder");
  cell.arm_source = readYamlFile(cell.arm_path);
  return readArm(cell.arm_source.root);
}

// Returns the tool axis in the frame of the last link, for an arm file that states none: the axis of a named capsule on
// that link that an obstacle allows to enter it. std::nullopt if there is no such capsule.
std::optional<Eigen::Vector3d> findToolAxis(const planner::Scene& scene) {
  for (const auto& body : scene.bodies) {
    const auto solid = std::dynamic_pointer_cast<const planner::Solid>(body.shape);
    const bool on_tool = body.frame_index + 1 == static_cast<int>(scene.links.size());
    const bool is_let_in = std::any_of(scene.obstacles.begin(), scene.obstacles.end(), [&](const auto& obstacle) {
      return std::find(obstacle.allow.begin(), obstacle.allow.end(), body.name) != obstacle.allow.end();
    });
    if (!on_tool || body.name.empty() || !is_let_in || !solid || !solid->isCapsule()) continue;
    const Eigen::Vector3d axis = solid->around().to - solid->around().from;
    if (axis.norm() > 1e-9) return axis.normalized();
  }
  return std::nullopt;
}

Cell cellOf(YamlFile file, const std::optional<std::string>& arm_text) {
  Cell cell;
  const std::string path = cell.path = file.path;
  cell.source = std::move(file);
  const YamlNode& root = cell.source.root;
  root.expectKeys({"arm", "base"},
                  {"name", "effects", "identify", "tubesheet", "calibration_tool", "scene", "link_shapes", "clearance",
                   "park", "gravity", "prior", "model_error", "uncertainty", "touched", "setups", "pair"});
  cell.name = root.find("name") ? root.at("name").text() : std::filesystem::path(path).stem().string();
  const ArmSource source = readCellArm(root.at("arm"), arm_text, cell);
  if (const YamlNode* pair = root.find("pair")) requireSamePair(*pair, source, cell);
  cell.arm = source.arm;
  cell.units = source.units;
  if (const YamlNode* gravity = root.find("gravity")) cell.arm.gravity_W = readDirection(*gravity);
  readBase(root.at("base"), cell);
  if (const YamlNode* setups = root.find("setups")) readSetups(*setups, cell.arm);
  if (const YamlNode* effects = root.find("effects")) cell.arm.effects = readEffects(*effects, cell.arm, cell.units);
  if (const YamlNode* identify = root.find("identify")) readIdentify(*identify, cell);
  if (const YamlNode* prior = root.find("prior")) readPriors(*prior, cell);
  if (const YamlNode* error = root.find("model_error")) readModelError(*error, cell);
  if (const YamlNode* uncertainty = root.find("uncertainty")) cell.uncertainty = readUncertainty(*uncertainty, cell);
  const auto folder = std::filesystem::path(path).parent_path();
  if (const YamlNode* sheet = root.find("tubesheet")) cell.sheet = readSheet(*sheet, cell.units, folder);
  if (const YamlNode* tool = root.find("calibration_tool")) {
    if (!cell.sheet) tool->failWithProblem("the cell has a calibration tool but no tube sheet", "add `tubesheet`");
    cell.tool = readSteppedTool(*tool, cell.units, cell.sheet->hole_diameter);
  }
  if (const YamlNode* park = root.find("park")) readPark(*park, cell);
  SceneSource scene = readScene(root, cell.arm, cell.units, folder);
  cell.scene = std::move(scene.scene);
  cell.meshes = std::move(scene.meshes);
  cell.warnings = sceneWarnings(cell.scene, cell.meshes, cell.arm, cell.X_WB);
  if (cell.sheet && cell.scene.bodies.empty())
    cell.warnings.emplace_back("the cell has no link_shapes: the arm is not checked against anything");
  if (cell.sheet && cell.sheet->layout_type == "map") warnOfHoles(*cell.sheet, cell.units, cell.warnings);
  const auto stated_by_scene = findToolAxis(cell.scene);
  if (!source.names_tool_axis) cell.arm.tool_axis_L = stated_by_scene.value_or(cell.arm.tool_axis_L);
  cell.tool_axis_stated = source.names_tool_axis || stated_by_scene.has_value();
  if (const YamlNode* touched = root.find("touched")) readTouched(*touched, cell);
  return cell;
}

}  // namespace

Cell readCell(const std::string& path) { return cellOf(readYamlFile(path), std::nullopt); }

Cell parseCell(const std::string& text, const std::string& path, const std::optional<std::string>& arm_text) {
  return cellOf({path, text, parseYaml(text, path)}, arm_text);
}

const tubesheets::Sheet& requireSheet(const Cell& cell, const std::string& purpose) {
  if (!cell.sheet)
    throw InputError::problem(cell.path, "there is no key 'tubesheet', which is needed to " + purpose,
                              "add the key, as in app/cells/mockup.yaml");
  return *cell.sheet;
}

const tubesheets::SteppedTool& requireTool(const Cell& cell, const std::string& purpose) {
  if (!cell.tool)
    throw InputError::problem(cell.path, "there is no key 'calibration_tool', which is needed to " + purpose,
                              "add the key, as in app/cells/mockup.yaml");
  return *cell.tool;
}

void requireToolAxis(const Cell& cell, const std::string& purpose) {
  if (!cell.tool_axis_stated)
    throw InputError::problem(
        cell.path, "the insertion direction of the tool is not stated, but is needed to " + purpose,
        "add tool: {axis: [x, y, z]} to the arm file, or a scene in which a capsule of the tool may touch the tube "
        "sheet");
}

}  // namespace tubeplan::app
