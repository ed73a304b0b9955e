#include "app/workbench/geometry_json.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/documents/figures.hpp"
#include "app/documents/pose_json.hpp"
#include "app/documents/sheet_json.hpp"
#include "app/formats/units.hpp"
#include "app/formats/units_json.hpp"
#include "planner/scene/outline.hpp"
#include "planner/scene/scene_shapes.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

constexpr std::size_t kMostDrawnTriangles = 20000;

/// Returns the sign of x in the drawing: -1 if the sheet is seen from below, where +x points left.
double signAsDrawn(const tubesheets::Sheet& sheet) {
  return sheet.viewed_from == tubesheets::ViewedFrom::kBelow ? -1 : 1;
}

json holesJson(const tubesheets::Sheet& sheet, const Units& units) {
  json row = json::array(), column = json::array(), x = json::array(), y = json::array(), z = json::array(),
       u = json::array(), state = json::array(), states = json::array(), state_words = json::array();
  const auto known = tubesheets::tubeStates();
  const double sign = signAsDrawn(sheet);
  for (const auto& tube : sheet.tubes) {
    row.push_back(tube.row);
    column.push_back(tube.column);
    x.push_back(lengthOf(tube.x, units));
    y.push_back(lengthOf(tube.y, units));
    z.push_back(0);
    u.push_back(sign * lengthOf(tube.x, units));
    state.push_back(static_cast<int>(std::find(known.begin(), known.end(), tube.state) - known.begin()));
  }
  for (const auto tube_state : known) {
    states.push_back(tubesheets::tubeStateName(tube_state));
    state_words.push_back(tubesheets::tubeStateWords(tube_state));
  }
  return {{"row", row}, {"column", column}, {"x", x},         {"y", y},           {"z", z},
          {"u", u},     {"v", y},           {"state", state}, {"states", states}, {"state_words", state_words}};
}

/// Returns the manway with u and v: the components of its direction from the sheet's middle in drawing coordinates.
json manwayOnMap(const tubesheets::Sheet& sheet, const Units& units) {
  json manway = manwayJson(sheet, units);
  if (!sheet.manway) return manway;
  const Eigen::Vector2d towards = sheet.manway->direction();
  manway["u"] = signAsDrawn(sheet) * towards.x();
  manway["v"] = towards.y();
  return manway;
}

/// Returns the value under a key path of the shape table, in which dots separate the keys of nested maps; null if it is
/// missing.
const YamlNode* findKeys(const YamlNode& node, std::string_view keys) {
  const std::size_t dot = keys.find('.');
  const YamlNode* found = node.find(keys.substr(0, dot));
  return found && dot != std::string_view::npos ? findKeys(*found, keys.substr(dot + 1)) : found;
}

/// Returns the value of a shape's field in the cell file: text, a number or an array of numbers. A missing value is
/// null for text, and zero for numbers.
json fieldJson(const YamlNode* value, const planner::ShapeField& field) {
  if (field.count == 0) return value ? json(value->text()) : json(nullptr);
  json numbers = json::array();
  for (int k = 0; k < field.count; ++k)
    numbers.push_back(!value ? 0 : field.count == 1 ? value->number() : value->items.at(k).number());
  return field.count == 1 ? numbers.front() : numbers;
}

/// Returns the shape of an entry of the cell file, as {kind, fields}; the numbers are already in the cell's units. The
/// kind is found in the planner's table of shapes.
json shapeJson(const YamlNode& node) {
  for (const auto& row : planner::sceneShapes()) {
    const YamlNode* fields = findKeys(node, row.key);
    if (!fields) continue;
    json shape = {{"kind", row.key}};
    for (const auto& field : row.fields) shape[std::string(field.name)] = fieldJson(fields->find(field.name), field);
    return shape;
  }
  return json::object();
}

/// Returns the coordinates of points, one point after another, to 1e-4 of a unit.
json coordinatesJson(const std::vector<Eigen::Vector3d>& points, const Units& units) {
  json coordinates = json::array();
  for (const Eigen::Vector3d& point : points)
    for (const double coordinate : point) coordinates.push_back(std::round(lengthOf(coordinate, units) * 1e4) / 1e4);
  return coordinates;
}

/// Returns an entry of the cell file with the outline of its shape; the outline is null for a region.
json namedShape(const YamlNode& node, const planner::Shape& made, const std::string& otherwise, const Units& units) {
  json shape = shapeJson(node);
  const auto* solid = dynamic_cast<const planner::Solid*>(&made);
  shape["outline"] = solid ? coordinatesJson(planner::outlineOf(*solid), units) : json(nullptr);
  const YamlNode* name = node.find("name");
  shape["name"] = name ? name->text() : otherwise;
  shape["allow"] = json::array();
  if (const YamlNode* allow = node.find("allow")) shape["allow"] = allow->texts();
  return shape;
}

std::vector<Eigen::Vector3d> cornersOf(const Eigen::AlignedBox3d& box) {
  std::vector<Eigen::Vector3d> corners;
  for (int k = 0; k < 8; ++k) corners.push_back(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k)));
  return corners;
}

/// Replaces the shape of a mesh by its bounding box. The key "mesh" describes the mesh, with the corners of all
/// triangles in the world frame if there are few enough triangles to draw.
void addMesh(const SceneMesh& mesh, const Units& units, json& shape) {
  const auto& box = mesh.shape->tree().bounds();
  json description = shape;
  for (const char* key : {"name", "allow", "kind"}) description.erase(key);
  description["file"] = std::filesystem::path(mesh.path).filename().string();
  description["solid"] = mesh.shape->survey().isClosed();
  const auto triangles = mesh.shape->tree().triangles();
  description["triangles"] = triangles.size();
  if (triangles.size() <= kMostDrawnTriangles) {
    json& positions = description["positions"] = json::array();
    for (const planner::Corners& corners : triangles)
      for (const Eigen::Vector3d& corner : corners)
        for (const double coordinate : corner) positions.push_back(lengthOf(coordinate, units));
  }
  shape = {{"kind", "box"},
           {"name", shape["name"]},
           {"allow", shape["allow"]},
           {"center", vectorJson(box.center(), units, dimension::kLength)},
           {"size", vectorJson(box.sizes(), units, dimension::kLength)},
           {"rpy", {0, 0, 0}},
           {"outline", coordinatesJson(cornersOf(box), units)},
           {"mesh", description}};
}

/// Returns the stepped tool, thinnest step first.
json toolJson(const std::optional<tubesheets::SteppedTool>& tool, const Units& units) {
  if (!tool) return nullptr;
  json diameters = json::array(), tolerances = json::array(), lengths = json::array();
  for (const auto& step : tool->steps) {
    diameters.push_back(lengthOf(step.diameter, units));
    tolerances.push_back(lengthOf(step.tolerance, units));
  }
  for (const double length : tool->lengths) lengths.push_back(lengthOf(length, units));
  return {{"diameters", diameters},
          {"tolerances", tolerances},
          {"lengths", lengths},
          {"step_words", tubesheets::stepWords(*tool)}};
}

}  // namespace

json sheetDrawing(const Cell& cell, const tubesheets::Sheet& sheet) {
  const Units& units = cell.units;
  return {{"name", sheet.name},
          {"units", unitsJson(units)},
          {"pitch", lengthOf(sheet.pitch, units)},
          {"hole_diameter", lengthOf(sheet.hole_diameter, units)},
          {"rows", sheet.rows},
          {"columns", sheet.columns},
          {"leg", tubesheets::legName(sheet.leg)},
          {"leg_words", tubesheets::legWords(sheet.leg)},
          {"viewing_side", tubesheets::viewedFromName(sheet.viewed_from)},
          {"view_words", tubesheets::viewedFromWords(sheet.viewed_from)},
          {"X_WS", poseJson(Eigen::Isometry3d::Identity(), units)},
          {"fingerprint", sheet.fingerprint()},
          {"tool", toolJson(cell.tool, units)},
          {"manway", manwayOnMap(sheet, units)},
          {"holes", holesJson(sheet, units)}};
}

json sceneDrawing(const Cell& cell) {
  json shapes = json::array(), arm = json::array();
  if (const YamlNode* scene = cell.source.root.find("scene"))
    for (const YamlNode& node : scene->items) {
      shapes.push_back(namedShape(node, *cell.scene.obstacles.at(shapes.size()).shape, "", cell.units));
      const auto name = shapes.back()["name"].get<std::string>();
      const auto mesh =
          std::find_if(cell.meshes.begin(), cell.meshes.end(), [&](const SceneMesh& m) { return m.obstacle == name; });
      if (mesh != cell.meshes.end()) addMesh(*mesh, cell.units, shapes.back());
    }
  const YamlNode* link_shapes = cell.source.root.find("link_shapes");
  auto body = cell.scene.bodies.begin();  // bodies are in the order of the links and of their entries
  for (std::size_t row = 0; row < cell.arm.rows.size(); ++row) {
    const auto& link = cell.arm.rows[row];
    json bodies = json::array();
    if (const YamlNode* of_link = link_shapes ? link_shapes->find(link.name) : nullptr)
      for (const YamlNode& node : of_link->items)
        bodies.push_back(namedShape(node, *body++->shape, link.name, cell.units));
    arm.push_back({{"row", row},
                   {"name", link.name},
                   {"moves", link.joint.type != deflection::JointType::kPassive},
                   {"bodies", bodies}});
  }
  return {{"units", unitsJson(cell.units)},
          {"clearance", lengthOf(cell.scene.clearance, cell.units)},
          {"shapes", shapes},
          {"warnings", cell.warnings},
          {"arm", arm},
          {"tip", vectorJson(cell.arm.p_LT, cell.units, dimension::kLength)},
          {"tool_axis", {cell.arm.tool_axis_L.x(), cell.arm.tool_axis_L.y(), cell.arm.tool_axis_L.z()}}};
}

}  // namespace tubeplan::app
