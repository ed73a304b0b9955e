#include "planner/scene_shapes.hpp"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "planner/mesh_shape.hpp"
#include "planner/separation.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Numbers = std::span<const double>;

Vector3d vectorAt(Numbers numbers, int start) { return {numbers[start], numbers[start + 1], numbers[start + 2]}; }

/// Pose with its origin half-way from `from` to `to` and z along them.
Isometry3d poseAlong(const Vector3d& from, const Vector3d& to) {
  Isometry3d X = Isometry3d::Identity();
  X.translation() = 0.5 * (from + to);
  if (from != to) X.linear() = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), to - from).toRotationMatrix();
  return X;
}

Isometry3d poseOf(const Vector3d& position, const Vector3d& rpy) {
  Isometry3d X = Isometry3d::Identity();
  X.translation() = position;
  X.linear() = (Eigen::AngleAxisd(rpy.z(), Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Vector3d::UnitY()) *
                Eigen::AngleAxisd(rpy.x(), Vector3d::UnitX()))
                   .toRotationMatrix();
  return X;
}

/// A capsule, or with both ends the same a sphere.
class CapsuleSolid : public Solid {
 public:
  explicit CapsuleSolid(const Capsule& capsule) : Solid(capsule, true, coreOf(capsule)) {}

  double pointDistance(const Vector3d& p) const override {
    return (nearestPoints(around().from, around().to, p, p).on_a - p).norm() - around().radius;
  }
  Vector3d support(const Vector3d& direction) const override {
    const bool to_end = direction.dot(around().to - around().from) > 0;
    return (to_end ? around().to : around().from) + around().radius * direction.normalized();
  }
  Vector3d farthestFrom(const Vector3d& p) const override {
    const bool to_end = (around().to - p).squaredNorm() > (around().from - p).squaredNorm();
    const Vector3d end = to_end ? around().to : around().from;
    return end == p ? Vector3d(p + around().radius * Vector3d::UnitX())
                    : Vector3d(end + around().radius * (end - p).normalized());
  }
  SegmentNearest nearestTo(const Vector3d& from, const Vector3d& to) const override {
    const auto [on_solid, on_segment] = nearestPoints(around().from, around().to, from, to);
    return {on_segment, on_solid};
  }

 private:
  static RoundedCore coreOf(const Capsule& capsule) {
    const double length = (capsule.to - capsule.from).norm();
    RoundedCore core{nullptr, poseAlong(capsule.from, capsule.to), capsule.radius};
    if (length > 0)
      core.geometry = std::make_shared<fcl::Capsuled>(0.0, length);
    else
      core.geometry = std::make_shared<fcl::Sphered>(0.0);
    return core;
  }
};

class BoxSolid : public Solid {
 public:
  BoxSolid(const Isometry3d& X_FC, const Vector3d& size)
      : Solid(aroundBox(X_FC, size), false, {std::make_shared<fcl::Boxd>(size), X_FC, 0}), box_{X_FC, 0.5 * size} {}

  double pointDistance(const Vector3d& p) const override {
    const Vector3d beyond = (box_.X_FC.inverse() * p).cwiseAbs() - box_.half;
    return beyond.cwiseMax(0.0).norm() + std::min(beyond.maxCoeff(), 0.0);
  }
  Vector3d support(const Vector3d& direction) const override {
    return box_.X_FC * corner(box_.X_FC.linear().transpose() * direction);
  }
  Vector3d farthestFrom(const Vector3d& p) const override { return box_.X_FC * corner(-(box_.X_FC.inverse() * p)); }
  SegmentNearest nearestTo(const Vector3d& from, const Vector3d& to) const override {
    const Isometry3d X_CF = box_.X_FC.inverse();
    const auto [on_segment, on_solid] = nearestToBox(X_CF * from, X_CF * to, box_.half);
    return {box_.X_FC * on_segment, box_.X_FC * on_solid};
  }
  const Box* box() const override { return &box_; }

 private:
  Vector3d corner(const Vector3d& towards) const {
    return box_.half.binaryExpr(towards, [](double half, double sign) { return std::copysign(half, sign); });
  }
  static Capsule aroundBox(const Isometry3d& X_FC, const Vector3d& size) {
    Eigen::Index longest = 0;
    const double length = size.maxCoeff(&longest);
    const Vector3d half_axis = 0.5 * length * X_FC.linear().col(longest);
    const double radius = 0.5 * std::sqrt(std::max(0.0, size.squaredNorm() - length * length));
    return {X_FC.translation() - half_axis, X_FC.translation() + half_axis, radius * (1 + 1e-12)};
  }

  Box box_;
};

/// A cylinder with flat ends.
class CylinderSolid : public Solid {
 public:
  CylinderSolid(const Vector3d& from, const Vector3d& to, double radius)
      : Solid({from, to, radius}, false,
              {std::make_shared<fcl::Cylinderd>(radius, (to - from).norm()), poseAlong(from, to), 0}),
        X_FC_(core().X_FC),
        radius_(radius),
        half_length_(0.5 * (to - from).norm()) {}

  double pointDistance(const Vector3d& p) const override {
    const Vector3d p_C = X_FC_.inverse() * p;
    const Eigen::Vector2d beyond(p_C.head<2>().norm() - radius_, std::abs(p_C.z()) - half_length_);
    return beyond.cwiseMax(0.0).norm() + std::min(beyond.maxCoeff(), 0.0);
  }
  Vector3d support(const Vector3d& direction) const override {
    return X_FC_ * rim(X_FC_.linear().transpose() * direction);
  }
  Vector3d farthestFrom(const Vector3d& p) const override { return X_FC_ * rim(-(X_FC_.inverse() * p)); }
  SegmentNearest nearestTo(const Vector3d& from, const Vector3d& to) const override {
    const Isometry3d X_CF = X_FC_.inverse();
    const auto [on_segment, on_solid] = nearestToCylinder(X_CF * from, X_CF * to, radius_, half_length_);
    return {X_FC_ * on_segment, X_FC_ * on_solid};
  }

 private:
  Vector3d rim(const Vector3d& towards) const {
    const double across = towards.head<2>().norm();
    const Eigen::Vector2d sideways =
        across > 0 ? Eigen::Vector2d(towards.head<2>() / across) : Eigen::Vector2d::UnitX();
    return {radius_ * sideways.x(), radius_ * sideways.y(), std::copysign(half_length_, towards.z())};
  }

  Isometry3d X_FC_;
  double radius_, half_length_;
};

/// The room inside a sphere; exact for every body.
class SphereInterior : public Shape {
 public:
  SphereInterior(const Vector3d& centre, double radius) : centre_(centre), radius_(radius) {}

  double pointDistance(const Vector3d& p) const override { return radius_ - (p - centre_).norm(); }
  Separation separationFrom(const Isometry3d& X_FB, const Solid& body) const override {
    const Vector3d farthest = X_FB * body.farthestFrom(X_FB.inverse() * centre_);
    return {pointDistance(farthest), farthest};
  }
  Separation separationFrom(const Capsule& body) const override {
    const bool to_end = (body.to - centre_).squaredNorm() > (body.from - centre_).squaredNorm();
    const Vector3d& end = to_end ? body.to : body.from;
    const double distance = (end - centre_).norm();
    const Vector3d outwards = distance > 0 ? Vector3d((end - centre_) / distance) : Vector3d::UnitX();
    return {radius_ - distance - body.radius, end + body.radius * outwards};
  }

 private:
  Vector3d centre_;
  double radius_;
};

/// The side of a plane that its normal points to; exact for every body.
class HalfSpace : public Shape {
 public:
  HalfSpace(const Vector3d& point, const Vector3d& normal) : point_(point), normal_(normal.normalized()) {}

  double pointDistance(const Vector3d& p) const override { return normal_.dot(p - point_); }
  Separation separationFrom(const Isometry3d& X_FB, const Solid& body) const override {
    const Vector3d lowest = X_FB * body.support(X_FB.linear().transpose() * -normal_);
    return {pointDistance(lowest), lowest};
  }
  Separation separationFrom(const Capsule& body) const override {
    const double from = pointDistance(body.from), to = pointDistance(body.to);
    return {std::min(from, to) - body.radius, (to < from ? body.to : body.from) - body.radius * normal_};
  }

 private:
  Vector3d point_, normal_;
};

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
     "The triangles of an STL, OBJ or PLY file, its origin at `position`, turned by rpy: solid where they close, else "
     "a "
     "surface.",
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

/// Empty where the field's numbers make sense.
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
    const std::string problem = mesh ? findMeshProblem(*mesh) : "nothing was handed over";
    if (!problem.empty()) return {nullptr, fmt::format("{}: {}", field->name, problem)};
  }
  return row.make(numbers, mesh);
}

}  // namespace tubeplan::planner
