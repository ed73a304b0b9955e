// The scene as data: what stands in the world, what the links look like, and what may touch what.
#pragma once

#include <string>
#include <utility>
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
  /// Bodies, by their indices, the first less, that are never apart (inseparableBodies): not judged, but named.
  std::vector<std::pair<int, int>> inseparable = {};
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

/// Whether two bodies, by their indices, are judged against one another unless they may touch: not where they are on
/// one piece or share a joint, where they always touch, nor where they are inseparable. Rows that do not move are one
/// piece with the row before them.
[[nodiscard]] bool areJudged(const Scene& scene, int a, int b);

}  // namespace tubeplan::planner
