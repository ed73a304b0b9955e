// The open table of scene shapes: one row per kind, with all that a reader, a help page or a drawing needs. A new shape
// is a row (and a class, if no present one fits) in scene_shapes.cpp; nothing else names a kind.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "planner/scene/shape.hpp"
#include "planner/scene/triangle_mesh.hpp"

namespace tubeplan::planner {

/// Meaning of a field's numbers, which decides their conversion by a reader and their valid values.
enum class ShapeQuantity {
  kPosition,   ///< any value [m]
  kSize,       ///< above zero [m]
  kDirection,  ///< no unit, any length but zero
  kAngle,      ///< any value [rad]
  kMesh,       ///< name of a file, whose triangles [m] the reader supplies; no number
  kUnit,       ///< name of that file's unit of length; no number
};

struct ShapeField {
  std::string_view name;
  ShapeQuantity quantity;
  int count;             ///< number of values; 0 for a name
  bool required = true;  ///< a field left out is all zeros
};

struct MadeShape {
  ShapePointer shape;   ///< the shape; empty if there is a problem
  std::string problem;  ///< field and reason; empty if there is none
};

struct ShapeRow {
  std::string_view key;   ///< key in a file; nested keys are separated by a dot (`inside_of.sphere`)
  std::string_view help;  ///< one sentence
  std::vector<ShapeField> fields;
  bool may_be_body;  ///< true: a link can have this shape, which only solids can
  MadeShape (*make)(std::span<const double> numbers, const TriangleMesh* mesh);
};

[[nodiscard]] const std::vector<ShapeRow>& sceneShapes();

/// Returns the row with this key, or null if there is none.
[[nodiscard]] const ShapeRow* findSceneShape(std::string_view key);

/// Returns the count of numbers that a row needs.
[[nodiscard]] int numberCount(const ShapeRow& row);

/// Returns the field of a row that names a mesh, or null if there is none.
[[nodiscard]] const ShapeField* findMeshField(const ShapeRow& row);

/// Builds a shape from its numbers, [m] and [rad], in the order of the row's fields, and from the mesh [m] if the row
/// names one. The problem reports a wrong count, a number that is not finite, a size not above zero, a zero direction,
/// an unusable mesh, or what the row itself finds wrong.
[[nodiscard]] MadeShape makeShape(const ShapeRow& row, std::span<const double> numbers,
                                  const TriangleMesh* mesh = nullptr);

}  // namespace tubeplan::planner
