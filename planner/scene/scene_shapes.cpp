#include "planner/scene/scene_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "planner/scene/mesh_shape.hpp"
#include "planner/scene/regions.hpp"
#include "planner/scene/solids.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Numbers = std::span<const double>;

Vector3d vectorAt(Numbers numbers, int start) { return {numbers[start], numbers[start + 1], numbers[start + 2]}; }

Isometry3d poseOf(const Vector3d& position, const Vector3d& rpy) {
  Isometry3d X = Isometry3d::Identity();
  X.translation() = position;
  X.linear() = (Eigen::AngleAxisd(rpy.z(), Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Vector3d::UnitY()) *
                Eigen::AngleAxisd(rpy.x(), Vector3d::UnitX()))
                   .toRotationMatrix();
  return X;
}

template <class S, class... Arguments>
MadeShape made(Arguments&&... arguments) {
  return {std::make_shared<const S>(std::forward<Arguments>(arguments)...), ""};
}

MadeShape makeCapsule(Numbers n, const TriangleMesh*) {
  return made<CapsuleSolid>(Capsule{vectorAt(n, 0), vectorAt(n, 3), n[6]});
}
MadeShape makeSphere(Numbers n, const TriangleMesh*) {
  return made<CapsuleSolid>(Capsule{vectorAt(n, 0), vectorAt(n, 0), n[3]});
}
MadeShape makeBox(Numbers n, const TriangleMesh*) {
  return made<BoxSolid>(poseOf(vectorAt(n, 0), vectorAt(n, 6)), vectorAt(n, 3));
}
MadeShape makeCylinder(Numbers n, const TriangleMesh*) {
  if (vectorAt(n, 0) == vectorAt(n, 3)) return {nullptr, "from and to are the same point: a cylinder needs a length"};
  return made<CylinderSolid>(vectorAt(n, 0), vectorAt(n, 3), n[6]);
}
MadeShape makeSphereInterior(Numbers n, const TriangleMesh*) { return made<SphereInterior>(vectorAt(n, 0), n[3]); }
MadeShape makeHalfSpace(Numbers n, const TriangleMesh*) { return made<HalfSpace>(vectorAt(n, 0), vectorAt(n, 3)); }

MadeShape makeMesh(Numbers n, const TriangleMesh* mesh) {
  return made<MeshShape>(*mesh, poseOf(vectorAt(n, 0), vectorAt(n, 3)));
}

using enum ShapeQuantity;
const std::vector<ShapeRow> kSceneShapes = {
    {"box",
     "A box about its centre, its edges along the axes unless turned by rpy (fixed-axis roll, pitch, yaw).",
     {{"center", kPosition, 3}, {"size", kSize, 3}, {"rpy", kAngle, 3, false}},
     true,
     makeBox},
    {"sphere", "A ball.", {{"center", kPosition, 3}, {"radius", kSize, 1}}, true, makeSphere},
    {"capsule",
     "All points within a radius of the segment between two points.",
     {{"from", kPosition, 3}, {"to", kPosition, 3}, {"radius", kSize, 1}},
     true,
     makeCapsule},
    {"cylinder",
     "A cylinder with flat ends, centred on two points.",
     {{"from", kPosition, 3}, {"to", kPosition, 3}, {"radius", kSize, 1}},
     true,
     makeCylinder},
    {"mesh",
     "The triangles of an STL, OBJ or PLY file, its origin at `position`, turned by rpy: a solid if they are closed, "
     "otherwise a surface.",
     {{"file", kMesh, 0}, {"unit", kUnit, 0, false}, {"position", kPosition, 3, false}, {"rpy", kAngle, 3, false}},
     false,
     makeMesh},
    {"inside_of.sphere",
     "The arm must stay inside this sphere.",
     {{"center", kPosition, 3}, {"radius", kSize, 1}},
     false,
     makeSphereInterior},
    {"keep_side",
     "The arm must stay on the side of the plane through a point that the normal points to.",
     {{"point", kPosition, 3}, {"normal", kDirection, 3}},
     false,
     makeHalfSpace},
};

/// Returns a message that says why a field's values are invalid; empty if they are valid.
std::string fieldProblem(const ShapeField& field, Numbers numbers) {
  const auto finite = [](double number) { return std::isfinite(number); };
  const auto zero = [](double number) { return number == 0; };
  if (!std::ranges::all_of(numbers, finite)) return fmt::format("{} is not a finite number", field.name);
  if (field.quantity == kSize && !std::ranges::all_of(numbers, [](double number) { return number > 0; }))
    return fmt::format("{} must be above zero", field.name);
  if (field.quantity == kDirection && std::ranges::all_of(numbers, zero))
    return fmt::format("{} has no length", field.name);
  return "";
}

}  // namespace

const std::vector<ShapeRow>& sceneShapes() { return kSceneShapes; }

const ShapeRow* findSceneShape(std::string_view key) {
  const auto found = std::ranges::find(kSceneShapes, key, &ShapeRow::key);
  return found == kSceneShapes.end() ? nullptr : &*found;
}

int numberCount(const ShapeRow& row) {
  return std::accumulate(row.fields.begin(), row.fields.end(), 0,
                         [](int sum, const ShapeField& field) { return sum + field.count; });
}

const ShapeField* findMeshField(const ShapeRow& row) {
  const auto found = std::ranges::find(row.fields, kMesh, &ShapeField::quantity);
  return found == row.fields.end() ? nullptr : &*found;
}

MadeShape makeShape(const ShapeRow& row, Numbers numbers, const TriangleMesh* mesh) {
  if (static_cast<int>(numbers.size()) != numberCount(row))
    return {nullptr, fmt::format("{} takes {} numbers, {} given", row.key, numberCount(row), numbers.size())};
  std::size_t start = 0;
  for (const ShapeField& field : row.fields) {
    const std::string problem = fieldProblem(field, numbers.subspan(start, field.count));
    if (!problem.empty()) return {nullptr, problem};
    start += field.count;
  }
  if (const ShapeField* field = findMeshField(row)) {
    const std::string problem = mesh ? findMeshProblem(*mesh) : "the mesh has no triangles";
    if (!problem.empty()) return {nullptr, fmt::format("{}: {}", field->name, problem)};
  }
  return row.make(numbers, mesh);
}

}  // namespace tubeplan::planner
