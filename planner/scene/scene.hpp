// The scene as data: what stands in the world, what the links look like, and what may touch what.
#pragma once

#include <string>
#include <vector>

#include "planner/scene/scene_shapes.hpp"

namespace tubeplan::planner {

/// One row of the arm, in order from the base. A row that does not move (passive) is one body with the row before it.
struct Link {
  std::string name;
  bool moves = true;
};

/// A solid or a region, fixed in the world.
struct Obstacle {
  std::string name;
  ShapePointer shape;
  std::vector<std::string> allow;  ///< links or bodies that may touch it
};

/// A solid carried by a link, in the link's own frame.
struct Body {
  std::string link;
  int frame_index = -1;            ///< of the link in Scene::links, and of its frame among the poses given
  std::string name;                ///< optional; the link's name stands in
  ShapePointer shape;              ///< must be a Solid
  std::vector<std::string> allow;  ///< obstacles, links or bodies that may touch it
};

struct Scene {
  std::vector<Link> links;
  std::vector<Obstacle> obstacles;
  std::vector<Body> bodies;
  double clearance = 0;  ///< m; the least distance to be kept between all that may not touch
};

/// What makes a scene unusable. `path` says where (`obstacle mezzanine: allow`).
struct SceneProblem {
  std::string path;
  std::string found;
  std::string expected;
};

/// Every problem of a scene: double or missing names, a link that the arm lacks, a shape missing or unfit for a body,
/// an `allow` that names nothing, a clearance that is negative or not finite. Empty means usable.
[[nodiscard]] std::vector<SceneProblem> findSceneProblems(const Scene& scene);

/// What a body is called in reports: its own name or its link's.
[[nodiscard]] const std::string& bodyLabel(const Body& body);

/// Whether the two may touch by the scene's `allow` lists, whichever of the two says so.
[[nodiscard]] bool mayTouch(const Obstacle& obstacle, const Body& body);
[[nodiscard]] bool mayTouch(const Body& a, const Body& b);

/// The number of each body's rigid group: rows that do not move count with the row before them, and groups without
/// bodies are left out. Bodies whose numbers differ by one or less are on the same piece or share a joint, where they
/// always touch, and are never judged against one another.
[[nodiscard]] std::vector<int> rigidGroups(const Scene& scene);

}  // namespace tubeplan::planner
