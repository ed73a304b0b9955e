#include "app/formats/cell/scene_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/formats/mesh/mesh_reader.hpp"
#include "app/formats/quantities.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"
#include "deflection/anchored_rows.hpp"
#include "deflection/flexible_kinematics.hpp"
#include "planner/collision/inseparable.hpp"

namespace tubeplan::app {

namespace {

using planner::ShapeQuantity;
using planner::ShapeRow;

Dimension shapeDimensionOf(ShapeQuantity quantity) {
  switch (quantity) {
    case ShapeQuantity::kPosition:
    case ShapeQuantity::kSize:
      return dimension::kLength;
    case ShapeQuantity::kAngle:
      return dimension::kAngle;
    case ShapeQuantity::kDirection:
    case ShapeQuantity::kMesh:
    case ShapeQuantity::kUnit:
      return dimension::kNone;
  }
  return dimension::kNone;
}

// Returns the words that may follow `prefix` ("" or "inside_of.") in the keys of the table of shapes.
std::vector<std::string> nextWords(std::string_view prefix) {
  std::vector<std::string> words;
  for (const ShapeRow& row : planner::sceneShapes()) {
    if (!row.key.starts_with(prefix)) continue;
    const std::string_view suffix = row.key.substr(prefix.size());
    const std::string word(suffix.substr(0, suffix.find('.')));
    if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
  }
  return words;
}

/// Row of the table of shapes, and the YAML map that has the shape's fields.
struct NamedShape {
  const ShapeRow* row;
  const YamlNode* fields;
};

// Follows the keys of a node down to a row of the table of shapes; `others` are further keys that the node may have.
NamedShape findShape(const YamlNode& node, const std::string& prefix, const std::vector<std::string>& others) {
  const std::vector<std::string> words = nextWords(prefix);
  std::vector<std::string> known = others;
  known.insert(known.end(), words.begin(), words.end());
  node.expectKeys({}, known);
  const YamlNode* chosen = nullptr;
  std::string key;
  for (const std::string& word : words) {
    const YamlNode* item = node.find(word);
    if (!item) continue;
    if (chosen) item->failWithProblem("the entry has a second shape, " + word, "move it to an entry of its own");
    chosen = item;
    key = prefix + word;
  }
  if (!chosen) node.fail("no shape", alternatives(words), "");
  if (const ShapeRow* row = planner::findSceneShape(key)) return {row, chosen};
  return findShape(*chosen, key + ".", {});
}

void readField(const YamlNode& node, const planner::ShapeField& field, const Units& units,
               std::vector<double>& numbers) {
  const Dimension unit = shapeDimensionOf(field.quantity);
  if (field.count == 1) {
    numbers.push_back(readQuantity(node, units, unit));
    return;
  }
  const auto count = static_cast<std::size_t>(field.count);
  for (const YamlNode& item : node.list(count, "a list of " + std::to_string(count) + " numbers"))
    numbers.push_back(readQuantity(item, units, unit));
}

/// Inputs for reading the shapes of a cell, and the meshes read so far.
struct SceneMeasurement {
  const Units& units;
  const std::filesystem::path& folder;
  double reach;  ///< reach of the arm [m]
  std::vector<SceneMesh> meshes;
};

// Limits of the ratio of a mesh's diagonal to the arm's reach. A mesh beyond these limits may be in another unit, so
// the cell must state the mesh's unit.
constexpr double kLargestShare = 3, kSmallestShare = 1. / 150;

void checkSize(const YamlNode& node, const planner::TriangleMesh& mesh, const SceneMeasurement& measurement) {
  const double size = planner::surveyMesh(mesh).bounds.diagonal().norm();
  if (size <= kLargestShare * measurement.reach && size >= kSmallestShare * measurement.reach) return;
  const auto text = [&](double length) {
    return fmt::format("{:.4g} {}", measurement.units.toFile(length, dimension::kLength),
                       measurement.units.length().name);
  };
  node.failWithProblem(
      fmt::format("the mesh would be {} across, while the arm reaches {}: the mesh may be in another unit of length",
                  text(size), text(measurement.reach)),
      fmt::format("state its unit (unit: mm), or write unit: {} if the size is right",
                  measurement.units.length().name));
}

/// Returns the mesh [m] of a shape that names a mesh file, and records the file; std::nullopt for other shapes.
std::optional<planner::TriangleMesh> readMesh(const NamedShape& shape, SceneMeasurement& measurement) {
  const planner::ShapeField* field = planner::findMeshField(*shape.row);
  if (!field) return std::nullopt;
  const YamlNode& node = shape.fields->at(field->name);
  const std::string path = (measurement.folder / node.text()).lexically_normal().string();
  if (std::error_code error; !std::filesystem::exists(path, error))
    node.failWithProblem("there is no file '" + path + "'",
                         "check the name of the mesh (.stl, .obj, .ply), which is relative to this cell's folder");
  MeshFile file = readMeshFile(path);
  const Unit* unit = nullptr;
  for (const auto& other : shape.row->fields)
    if (const YamlNode* name = shape.fields->find(other.name); name && other.quantity == ShapeQuantity::kUnit) {
      unit = findUnit(UnitKind::kLength, name->text());
      if (!unit) name->fail("the unknown unit '" + name->text() + "'", alternatives(unitNames(UnitKind::kLength)), "");
    }
  for (Eigen::Vector3d& vertex : file.mesh.vertices) vertex *= (unit ? *unit : measurement.units.length()).factor;
  if (!unit) checkSize(node, file.mesh, measurement);
  measurement.meshes.push_back({node.path, "", path, file.fingerprint, nullptr});
  return std::move(file.mesh);
}

planner::ShapePointer makeShape(const NamedShape& shape, SceneMeasurement& measurement) {
  std::vector<std::string> required, optional;
  for (const auto& field : shape.row->fields) (field.required ? required : optional).emplace_back(field.name);
  shape.fields->expectKeys(required, optional);
  std::vector<double> numbers;
  for (const auto& field : shape.row->fields) {
    const YamlNode* node = shape.fields->find(field.name);
    if (node && field.count > 0)
      readField(*node, field, measurement.units, numbers);
    else
      numbers.insert(numbers.end(), static_cast<std::size_t>(field.count), 0.0);
  }
  const auto mesh = readMesh(shape, measurement);
  planner::MadeShape made = planner::makeShape(*shape.row, numbers, mesh ? &*mesh : nullptr);
  if (!made.shape) shape.fields->failWithProblem(made.problem);
  if (mesh) measurement.meshes.back().shape = std::dynamic_pointer_cast<const planner::MeshShape>(made.shape);
  return made.shape;
}

std::vector<std::string> readAllow(const YamlNode& node) {
  const YamlNode* allow = node.find("allow");
  return allow ? allow->texts() : std::vector<std::string>{};
}

planner::Obstacle readObstacle(const YamlNode& node, SceneMeasurement& measurement) {
  const NamedShape shape = findShape(node, "", {"name", "allow"});
  const std::size_t meshes = measurement.meshes.size();
  planner::Obstacle obstacle{node.at("name").text(), makeShape(shape, measurement), readAllow(node)};
  if (measurement.meshes.size() > meshes) measurement.meshes.back().obstacle = obstacle.name;
  return obstacle;
}

/// Returns the keys of the shapes that a link can have.
std::vector<std::string> bodyShapes() {
  std::vector<std::string> keys;
  for (const ShapeRow& row : planner::sceneShapes())
    if (row.may_be_body) keys.emplace_back(row.key);
  return keys;
}

planner::Body readBody(const YamlNode& node, SceneMeasurement& measurement) {
  const NamedShape shape = findShape(node, "", {"name", "allow"});
  if (!shape.row->may_be_body)
    shape.fields->failWithProblem("a link cannot have this shape, because the body of a link must be convex",
                                  "write one of these: " + alternatives(bodyShapes()));
  planner::Body body;
  body.shape = makeShape(shape, measurement);
  body.allow = readAllow(node);
  if (const YamlNode* name = node.find("name")) body.name = name->text();
  return body;
}

void readLinkShapes(const YamlNode& node, SceneMeasurement& measurement, planner::Scene& scene) {
  std::vector<std::string> names;
  for (const auto& link : scene.links) names.push_back(link.name);
  node.expectKeys({}, names);
  for (std::size_t row = 0; row < scene.links.size(); ++row) {
    const YamlNode* shapes = node.find(scene.links[row].name);
    if (!shapes) continue;
    for (const YamlNode& item : shapes->list()) {
      planner::Body body = readBody(item, measurement);
      body.link = scene.links[row].name;
      body.frame_index = static_cast<int>(row);
      scene.bodies.push_back(std::move(body));
    }
  }
}

const YamlNode* findNamed(const YamlNode& list, const std::string& path, const std::string& prefix) {
  for (const YamlNode& item : list.items) {
    const YamlNode* name = item.find("name");
    if (name && (path == prefix + name->scalar || path.starts_with(prefix + name->scalar + ":"))) return &item;
  }
  return nullptr;
}

// Returns the entry of a cell to which a problem's path refers ("obstacle mezzanine: allow", "body tool-tip",
// "clearance"); the whole cell if there is no such entry.
const YamlNode& findProblemNode(const YamlNode& cell, const std::string& path) {
  const YamlNode* found = cell.find(path);
  if (const YamlNode* scene = cell.find("scene"); scene && !found) found = findNamed(*scene, path, "obstacle ");
  if (const YamlNode* shapes = cell.find("link_shapes"); shapes && !found)
    for (std::size_t i = 0; i < shapes->items.size() && !found; ++i) found = findNamed(shapes->items[i], path, "body ");
  return found ? *found : cell;
}

}  // namespace

SceneSource readScene(const YamlNode& cell, const deflection::Arm& arm, const Units& units,
                      const std::filesystem::path& folder) {
  SceneMeasurement measurement{units, folder, deflection::reachOf(arm), {}};
  planner::Scene scene;
  for (const auto& row : arm.rows) scene.links.push_back({row.name, row.joint.type != deflection::JointType::kPassive});
  if (const YamlNode* obstacles = cell.find("scene"))
    for (const YamlNode& node : obstacles->list()) scene.obstacles.push_back(readObstacle(node, measurement));
  if (const YamlNode* shapes = cell.find("link_shapes")) readLinkShapes(*shapes, measurement, scene);
  scene.clearance = readQuantityOr(cell, "clearance", units, dimension::kLength, 0);
  const auto problems = planner::findSceneProblems(scene);
  if (problems.empty()) {
    scene.inseparable = planner::inseparableBodies(arm, scene);
    return {std::move(scene), std::move(measurement.meshes)};
  }
  const planner::SceneProblem& first = problems.front();
  throw InputError(findProblemNode(cell, first.path).where(first.path), first.found, first.expected);
}

namespace {

/// Returns descriptions of the moving parts of the arm that no body covers; contacts with these parts are not checked.
std::vector<std::string> bareMembers(const planner::Scene& scene, const deflection::Arm& written,
                                     const Eigen::Isometry3d& X_WB) {
  // Shortest member that needs a body, as a fraction of the arm's reach; shorter members lie within their neighbours'
  // bodies.
  constexpr double kLong = 0.08;
  constexpr double kNear = 0.25;  // largest distance of a covering body from a member's middle, relative to its length
  std::vector<std::string> bare;
  const auto [arm, slid] = deflection::anchoredRows(written);
  const auto active = deflection::activeRows(arm);
  Eigen::VectorXd q(static_cast<Eigen::Index>(active.size()));
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    const auto& joint = arm.joint(k);
    const double middle = (joint.lower + joint.upper) / 2;
    q[k] = std::isfinite(middle) ? middle : 0;
  }
  const auto shape = deflection::solveFlexibleKinematics(arm, {q, 0, deflection::gravityInBase(arm, X_WB)});
  if (shape.status != deflection::KinematicsStatus::kConverged || active.empty()) return bare;
  for (auto i = static_cast<std::size_t>(active.front()); i < shape.rows.size(); ++i) {
    const bool is_last = i + 1 == shape.rows.size();
    const auto& X_BL = shape.rows[i].X_BL_rigid;
    const Eigen::Vector3d from = X_BL.p,
                          to = is_last ? Eigen::Vector3d(X_BL.p + X_BL.R * arm.p_LT) : shape.rows[i + 1].X_BL_rigid.p;
    const double length = (to - from).norm();
    if (length < kLong * deflection::reachOf(arm)) continue;
    const auto middleOf = [&](const planner::Body& body) {
      const auto row = static_cast<std::size_t>(body.frame_index);
      const auto& X_BO = shape.rows[row].X_BL_rigid;
      return Eigen::Vector3d(X_BO.R.transpose() * ((from + to) / 2 - X_BO.p) + slid[row] * Eigen::Vector3d::UnitZ());
    };
    const bool is_covered = std::ranges::any_of(scene.bodies, [&](const planner::Body& body) {
      return body.shape->pointDistance(middleOf(body)) <= kNear * length;
    });
    if (!is_covered)
      bare.push_back(is_last ? arm.rows[i].name + " to the tip" : arm.rows[i].name + " to " + arm.rows[i + 1].name);
  }
  return bare;
}

}  // namespace

std::vector<std::string> sceneWarnings(const planner::Scene& scene, const std::vector<SceneMesh>& meshes,
                                       const deflection::Arm& arm, const Eigen::Isometry3d& X_WB) {
  std::vector<std::string> warnings;
  for (const auto& [a, b] : scene.inseparable)
    warnings.push_back(
        fmt::format("the shapes of {} and {} are too close in every posture: they are not checked against each other",
                    planner::bodyLabel(scene.bodies[static_cast<std::size_t>(a)]),
                    planner::bodyLabel(scene.bodies[static_cast<std::size_t>(b)])));
  if (const auto bare = bareMembers(scene, arm, X_WB); !scene.bodies.empty() && !bare.empty())
    warnings.push_back(fmt::format("no shape of link_shapes is along the arm from {}: nothing is checked there",
                                   fmt::join(bare, ", from ")));
  for (const SceneMesh& mesh : meshes) {
    if (!mesh.shape->survey().isClosed())
      warnings.push_back(fmt::format("{} ({}) is {}; the space inside it counts as free", mesh.obstacle, mesh.path,
                                     planner::describe(mesh.shape->survey())));
    if (mesh.shape->pointDistance(X_WB.translation()) > deflection::reachOf(arm))
      warnings.push_back(
          fmt::format("{} ({}) is out of the arm's reach: check its position and unit", mesh.obstacle, mesh.path));
  }
  return warnings;
}

}  // namespace tubeplan::app
