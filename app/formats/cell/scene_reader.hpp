// Reader of a cell's scene: obstacles in the world frame and bodies on the links, each with a shape that the planner
// supports.
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

/// Mesh file that a scene names.
struct SceneMesh {
  std::string key;          ///< YAML path of the file's name in the cell: "scene[3].mesh.file"
  std::string obstacle;     ///< name of the obstacle that has this shape
  std::string path;         ///< path of the mesh file
  std::string fingerprint;  ///< fingerprint of the file's bytes
  std::shared_ptr<const planner::MeshShape> shape;
};

struct SceneSource {
  planner::Scene scene;
  std::vector<SceneMesh> meshes;
};

/// Reads the optional keys `scene`, `link_shapes` and `clearance` of a cell; names of files in them are relative to
/// `folder`. Throws InputError for an unknown shape, link or field, and for problems found by
/// planner::findSceneProblems and readMeshFile. Also throws InputError for a mesh without a stated unit whose size is
/// implausible for the arm's reach.
[[nodiscard]] SceneSource readScene(const YamlNode& cell, const deflection::Arm& arm, const Units& units,
                                    const std::filesystem::path& folder);

/// Returns warnings about the scene: bodies that are too close to each other in every posture, parts of the arm without
/// a body, meshes that are not closed, and meshes that the arm cannot reach from its base.
[[nodiscard]] std::vector<std::string> sceneWarnings(const planner::Scene& scene, const std::vector<SceneMesh>& meshes,
                                                     const deflection::Arm& arm, const Eigen::Isometry3d& X_WB);

}  // namespace tubeplan::app
