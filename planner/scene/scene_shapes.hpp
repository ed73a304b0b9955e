// The extensible table of scene shapes: one row per kind, with everything that file readers, help pages and drawings
// need. To add a kind of shape, add a row in scene_shapes.cpp, and a class if no existing class fits.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "planner/scene/shape.hpp"
#include "planner/scene/triangle_mesh.hpp"

namespace tubeplan::planner {

/// Meaning of a field's values, which determines how a file reader converts them and which values are valid.
enum class ShapeQuantity {
  kPosition,   ///< any value [m]
  kSize,       ///< above zero [m]
  kDirection,  ///< no unit, any length except zero
  kAngle,      ///< any value [rad]
  kMesh,       ///< name of a mesh file, no values; the file reader supplies its triangles [m]
  kUnit,       ///< name of the unit of length in the mesh file, no values
};

struct ShapeField {
  std::string_view name;
  ShapeQuantity quantity;
  int count;             ///< number of values; 0 for a name
  bool required = true;  ///< if false, the field is optional; by default it is all zeros
};

struct MadeShape {
  ShapePointer shape;   ///< the shape; null if there is a problem
  std::string problem;  ///< name of the field with the error, and the reason; empty if there is none
};

struct ShapeRow {
  std::string_view key;   ///< key of the shape in a file; nested keys are separated by a dot (`inside_of.sphere`)
  std::string_view help;  ///< description for help pages, one sentence
  std::vector<ShapeField> fields;
  bool may_be_body;  ///< true if a link can have this shape, which must then be a solid
  MadeShape (*make)(std::span<const double> numbers, const TriangleMesh* mesh);
};

[[nodiscard]] const std::vector<ShapeRow>& sceneShapes();

/// Returns the row with this key, or null if there is none.
[[nodiscard]] const ShapeRow* findSceneShape(std::string_view key);

/// Returns the number of values in all fields of a row.
[[nodiscard]] int numberCount(const ShapeRow& row);

/// Returns the field of a row that names a mesh, or null if there is none.
[[nodiscard]] const ShapeField* findMeshField(const ShapeRow& row);

/// Builds a shape from its values, [m] and [rad], in the order of the row's fields, and from the mesh [m] if the row
/// has a mesh field. The problem reports a wrong number of values, a value that is not finite, a size not above zero, a
/// zero direction, an unusable mesh, or a fault found by the row's `make`.
[[nodiscard]] MadeShape makeShape(const ShapeRow& row, std::span<const double> numbers,
                                  const TriangleMesh* mesh = nullptr);

}  // namespace tubeplan::planner
