// A cell's scene: obstacles in the world and shapes on the links, by the planner's table of shapes.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "app/formats/yaml/yaml_node.hpp"
#include "deflection/arm.hpp"
#include "planner/scene/mesh_shape.hpp"
#include "planner/scene/scene.hpp"

namespace tubeplan::app {

/// A mesh that the scene names.
struct SceneMesh {
  std::string key;          ///< where its name stands in the cell: "scene[3].mesh.file"
  std::string obstacle;     ///< whose shape it is
  std::string path;         ///< of the file
  std::string fingerprint;  ///< of what is in it
  std::shared_ptr<const planner::MeshShape> shape;
};

struct SceneSource {
  planner::Scene scene;
  std::vector<SceneMesh> meshes;
};

/// Reads the keys scene, link_shapes and clearance of a cell, each of which may be missing; the files that they name
/// are relative to `folder`. Throws InputError for an unknown shape, link or field, for what planner::findSceneProblems
/// and readMeshFile find, and for a mesh without a unit whose size makes no sense beside the arm's reach.
[[nodiscard]] SceneSource readScene(const YamlNode& cell, const deflection::Arm& arm, const Units& units,
                                    const std::filesystem::path& folder);

/// What should be looked at: bodies that are inseparable, meshes that are not closed, or that stand where the arm, from
/// its base, does not reach.
[[nodiscard]] std::vector<std::string> sceneWarnings(const planner::Scene& scene, const std::vector<SceneMesh>& meshes,
                                                     const deflection::Arm& arm, const Eigen::Isometry3d& X_WB);

}  // namespace tubeplan::app
