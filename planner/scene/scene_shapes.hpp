// The open table of scene shapes: one row per kind, with all that a reader, a help page or a drawing needs to know of
// it. Adding a shape is adding its row (and its class, if no present one serves) in scene_shapes.cpp; nothing else
// names a kind.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "planner/scene/shape.hpp"
#include "planner/scene/triangle_mesh.hpp"

namespace tubeplan::planner {

/// What a field's numbers are, hence how a reader converts them and which values make sense.
enum class ShapeQuantity {
  kPosition,   ///< m, any
  kSize,       ///< m, above zero
  kDirection,  ///< no unit, any length but zero
  kAngle,      ///< rad, any
  kMesh,       ///< the name of a file: the reader hands over its triangles [m]; no number
  kUnit,       ///< the name of that file's unit of length; no number
};

struct ShapeField {
  std::string_view name;
  ShapeQuantity quantity;
  int count;             ///< of numbers; 0 for a name
  bool required = true;  ///< a field left out is all zeros
};

struct MadeShape {
  ShapePointer shape;   ///< empty where there is a problem
  std::string problem;  ///< says which field and why; empty where there is none
};

struct ShapeRow {
  std::string_view key;   ///< as a file writes it; nested keys are parted by a dot (`inside_of.sphere`)
  std::string_view help;  ///< one sentence
  std::vector<ShapeField> fields;
  bool may_be_body;  ///< whether a link can have this shape: only solids can
  MadeShape (*make)(std::span<const double> numbers, const TriangleMesh* mesh);
};

[[nodiscard]] const std::vector<ShapeRow>& sceneShapes();

/// The row with this key; null where there is none.
[[nodiscard]] const ShapeRow* findSceneShape(std::string_view key);

/// How many numbers a row wants.
[[nodiscard]] int numberCount(const ShapeRow& row);

/// The field of a row that names a mesh; null where there is none.
[[nodiscard]] const ShapeField* findMeshField(const ShapeRow& row);

/// Builds a shape from its numbers, [m] and [rad], field after field as the row lists them, and of a row that names one
/// the mesh [m]. A wrong count, a number that is not finite, a size that is not above zero, a zero direction, a mesh
/// that cannot be used or what the row itself finds wrong is given as the problem.
[[nodiscard]] MadeShape makeShape(const ShapeRow& row, std::span<const double> numbers,
                                  const TriangleMesh* mesh = nullptr);

}  // namespace tubeplan::planner
