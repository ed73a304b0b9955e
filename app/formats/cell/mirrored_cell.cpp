#include "app/formats/cell/mirrored_cell.hpp"

#include <fmt/format.h>

#include "app/formats/sheet/touched_base.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "app/formats/yaml/yaml_edit.hpp"
#include "planner/scene/scene_shapes.hpp"

namespace tubeplan::app {

namespace {

using planner::ShapeQuantity;

constexpr const char* kOwnCell = "write a cell of its own for the other leg";

std::string negated(const YamlNode& number) {
  const std::string& text = number.scalar;
  if (number.number() == 0) return text;
  return text.front() == '-' ? text.substr(1) : "-" + (text.front() == '+' ? text.substr(1) : text);
}

/// Returns a list of three numbers as text. Changes the signs of the numbers marked in `changes`, and keeps the digits
/// as written.
std::string withSigns(const YamlNode& list, std::array<bool, 3> changes) {
  const auto& items = list.list(3, "three numbers");
  const auto item = [&](std::size_t k) { return changes[k] ? negated(items[k]) : items[k].scalar; };
  return fmt::format("[{}, {}, {}]", item(0), item(1), item(2));
}

/// Returns the mirror image of a point or a direction.
std::string mirroredVector(const YamlNode& vector) { return withSigns(vector, {false, true, false}); }

/// Returns the fixed-axis angles of M R M, where R is the rotation by the given angles and M mirrors y.
std::string mirroredAngles(const YamlNode& rpy) { return withSigns(rpy, {true, false, true}); }

/// Collects changes of a cell's text. Each change leaves the rest of the text untouched.
class Mirror {
 public:
  explicit Mirror(const Cell& cell) : root_(cell.source.root), text_(cell.source.text) {}

  void change(const YamlNode* node, std::string (*mirrored)(const YamlNode&)) {
    if (node) text_ = withYamlValue(text_, node->path, mirrored(*node));
  }
  void change(std::string_view path, std::string (*mirrored)(const YamlNode&)) {
    change(findNode(root_, path), mirrored);
  }
  void set(std::string_view path, std::string_view value) { text_ = withYamlValue(text_, path, value); }
  void drop(std::string_view path) {
    if (findNode(root_, path)) text_ = withoutYamlValue(text_, path);
  }

  /// Mirrors the shapes of all obstacles: each field according to its quantity in the planner's table of shapes.
  void changeScene() {
    const YamlNode* scene = root_.find("scene");
    if (!scene) return;
    for (const YamlNode& obstacle : scene->list())
      for (const planner::ShapeRow& row : planner::sceneShapes())
        if (const YamlNode* shape = findNode(root_, fmt::format("{}.{}", obstacle.path, row.key)))
          changeShape(*shape, row);
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void changeShape(const YamlNode& shape, const planner::ShapeRow& row) {
    for (const planner::ShapeField& field : row.fields) {
      const YamlNode* value = shape.find(field.name);
      if (!value) continue;
      if (field.quantity == ShapeQuantity::kMesh)
        value->failWithProblem("the other leg needs the mirror image of this mesh, which needs a separate file",
                               kOwnCell);
      if (field.quantity == ShapeQuantity::kPosition || field.quantity == ShapeQuantity::kDirection)
        change(value, mirroredVector);
      if (field.quantity == ShapeQuantity::kAngle) change(value, mirroredAngles);
    }
  }

  const YamlNode& root_;
  std::string text_;
};

/// Returns the name of the other leg. Throws InputError for a sheet that has none or is not made from a layout.
std::string_view otherLeg(const Cell& cell) {
  const tubesheets::Sheet& sheet = requireSheet(cell, "mirror it for the other leg");
  const YamlNode& leg = cell.source.root.at("tubesheet").at("leg");
  if (sheet.leg == tubesheets::Leg::kFull)
    leg.failWithProblem("a full sheet has no other leg", "list only the leg `full`");
  if (sheet.map) leg.failWithProblem("the other leg needs a hole map of its own", kOwnCell);
  return tubesheets::legName(sheet.leg == tubesheets::Leg::kHot ? tubesheets::Leg::kCold : tubesheets::Leg::kHot);
}

}  // namespace

std::string mirroredCellText(const Cell& cell) {
  Mirror mirror(cell);
  mirror.set("tubesheet.leg", otherLeg(cell));
  mirror.change("tubesheet.manway.center", mirroredVector);
  mirror.change("base.position", mirroredVector);
  mirror.change("base.rpy", mirroredAngles);
  mirror.set("base.known", "false");
  mirror.change("gravity", mirroredVector);
  mirror.changeScene();
  mirror.drop("base.covariance");
  mirror.drop("park");
  return withoutTouched(mirror.text());
}

Cell mirroredCell(const Cell& cell) {
  return parseCell(mirroredCellText(cell), cell.path,
                   cell.arm_source.text.empty() ? std::nullopt : std::optional(cell.arm_source.text));
}

}  // namespace tubeplan::app
