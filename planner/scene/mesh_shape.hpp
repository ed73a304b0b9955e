// A triangle mesh as an obstacle.
#pragma once

#include "planner/scene/shape.hpp"
#include "planner/scene/triangle_tree.hpp"

namespace tubeplan::planner {

/// A shape of triangles. A closed mesh is solid: a body wholly inside is in contact with the mesh. An open mesh is a
/// surface without thickness.
class MeshShape : public Shape {
 public:
  /// `mesh` must be usable (findMeshProblem()); X_FM is the pose of its frame M in F.
  MeshShape(const TriangleMesh& mesh, const Eigen::Isometry3d& X_FM);

  [[nodiscard]] double pointDistance(const Eigen::Vector3d& p_F) const override;
  [[nodiscard]] Separation separationFrom(const Eigen::Isometry3d& X_FB, const Solid& body) const override;
  [[nodiscard]] Separation separationFrom(const Capsule& body_F) const override;
  [[nodiscard]] bool isFartherThan(double distance, const Capsule& body_F) const override;

  [[nodiscard]] const MeshSurvey& survey() const { return survey_; }
  [[nodiscard]] const TriangleTree& tree() const { return tree_; }

 private:
  [[nodiscard]] bool isInside(const Eigen::Vector3d& p_F) const;

  MeshSurvey survey_;
  TriangleTree tree_;
};

}  // namespace tubeplan::planner
