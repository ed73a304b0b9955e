#include "app/readers/scene_reader.hpp"

#include <algorithm>

#include "app/input_error.hpp"
#include "app/readers/quantities.hpp"
#include "app/suggestion.hpp"

namespace tubeplan::app {

namespace {

using planner::ShapeQuantity;
using planner::ShapeRow;

Dimension dimensionOf(ShapeQuantity quantity) {
  switch (quantity) {
    case ShapeQuantity::kPosition:
    case ShapeQuantity::kSize:
      return dimension::kLength;
    case ShapeQuantity::kAngle:
      return dimension::kAngle;
    case ShapeQuantity::kDirection:
      return dimension::kNone;
  }
  return dimension::kNone;
}

// The words that may follow `prefix` ("" or "inside_of.") in the table's keys.
std::vector<std::string> nextWords(std::string_view prefix) {
  std::vector<std::string> words;
  for (const ShapeRow& row : planner::sceneShapes()) {
    if (!row.key.starts_with(prefix)) continue;
    const std::string_view rest = row.key.substr(prefix.size());
    const std::string word(rest.substr(0, rest.find('.')));
    if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
  }
  return words;
}

/// A row of the table and the map with its fields.
struct NamedShape {
  const ShapeRow* row;
  const YamlNode* fields;
};

// Follows the keys down to a row of the table; `others` are keys beside the shape's.
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
    if (chosen) item->fail("a second shape, " + word, "one shape for each entry", "make it an entry of its own");
    chosen = item;
    key = prefix + word;
  }
  if (!chosen) node.fail("no shape", alternatives(words), "");
  if (const ShapeRow* row = planner::findSceneShape(key)) return {row, chosen};
  return findShape(*chosen, key + ".", {});
}

void readField(const YamlNode& node, const planner::ShapeField& field, const Units& units,
               std::vector<double>& numbers) {
  const Dimension unit = dimensionOf(field.quantity);
  if (field.count == 1) {
    numbers.push_back(readQuantity(node, units, unit));
    return;
  }
  const auto count = static_cast<std::size_t>(field.count);
  for (const YamlNode& item : node.list(count, "a list of " + std::to_string(count) + " numbers"))
    numbers.push_back(readQuantity(item, units, unit));
}

planner::ShapePointer makeShape(const NamedShape& shape, const Units& units) {
  std::vector<std::string> required, optional;
  for (const auto& field : shape.row->fields) (field.required ? required : optional).emplace_back(field.name);
  shape.fields->expectKeys(required, optional);
  std::vector<double> numbers;
  for (const auto& field : shape.row->fields) {
    const YamlNode* node = shape.fields->find(field.name);
    if (node)
      readField(*node, field, units, numbers);
    else
      numbers.insert(numbers.end(), static_cast<std::size_t>(field.count), 0.0);
  }
  planner::MadeShape made = planner::makeShape(*shape.row, numbers);
  if (!made.shape) shape.fields->fail(made.problem, "a shape with a size", "");
  return made.shape;
}

std::vector<std::string> readAllow(const YamlNode& node) {
  const YamlNode* allow = node.find("allow");
  return allow ? allow->texts() : std::vector<std::string>{};
}

planner::Obstacle readObstacle(const YamlNode& node, const Units& units) {
  const NamedShape shape = findShape(node, "", {"name", "allow"});
  return {node.at("name").text(), makeShape(shape, units), readAllow(node)};
}

planner::Body readBody(const YamlNode& node, const Units& units) {
  const NamedShape shape = findShape(node, "", {"name", "allow"});
  if (!shape.row->may_be_body) shape.fields->fail("a region", "a solid: a link has a body, not a room to stay in", "");
  planner::Body body;
  body.shape = makeShape(shape, units);
  body.allow = readAllow(node);
  if (const YamlNode* name = node.find("name")) body.name = name->text();
  return body;
}

void readLinkShapes(const YamlNode& node, const Units& units, planner::Scene& scene) {
  std::vector<std::string> names;
  for (const auto& link : scene.links) names.push_back(link.name);
  node.expectKeys({}, names);
  for (std::size_t row = 0; row < scene.links.size(); ++row) {
    const YamlNode* shapes = node.find(scene.links[row].name);
    if (!shapes) continue;
    for (const YamlNode& item : shapes->list()) {
      planner::Body body = readBody(item, units);
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

// The entry that a problem's path ("obstacle mezzanine: allow", "body tool-tip", "clearance") speaks of, or the whole
// cell.
const YamlNode& findProblemNode(const YamlNode& cell, const std::string& path) {
  const YamlNode* found = cell.find(path);
  if (const YamlNode* scene = cell.find("scene"); scene && !found) found = findNamed(*scene, path, "obstacle ");
  if (const YamlNode* shapes = cell.find("link_shapes"); shapes && !found)
    for (std::size_t i = 0; i < shapes->items.size() && !found; ++i) found = findNamed(shapes->items[i], path, "body ");
  return found ? *found : cell;
}

}  // namespace

planner::Scene readScene(const YamlNode& cell, const deflection::Arm& arm, const Units& units) {
  planner::Scene scene;
  for (const auto& row : arm.rows) scene.links.push_back({row.name, row.joint.type != deflection::JointType::kPassive});
  if (const YamlNode* obstacles = cell.find("scene"))
    for (const YamlNode& node : obstacles->list()) scene.obstacles.push_back(readObstacle(node, units));
  if (const YamlNode* shapes = cell.find("link_shapes")) readLinkShapes(*shapes, units, scene);
  scene.clearance = readQuantityOr(cell, "clearance", units, dimension::kLength, 0);
  const auto problems = planner::findSceneProblems(scene);
  if (problems.empty()) return scene;
  const planner::SceneProblem& first = problems.front();
  throw InputError(findProblemNode(cell, first.path).where(first.path), first.found, first.expected);
}

}  // namespace tubeplan::app
