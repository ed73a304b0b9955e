// The scene as data: obstacles in the world, bodies of the links, and what may touch what.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "planner/scene/scene_shapes.hpp"

namespace tubeplan::planner {

/// A row of the arm, in order from the base. A row that does not move (passive) is one body with the row before it.
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
  int frame_index = -1;            ///< index of the link in Scene::links, and of its frame among the given poses
  std::string name;                ///< optional; the default is the link's name
  ShapePointer shape;              ///< must be a Solid
  std::vector<std::string> allow;  ///< obstacles, links or bodies that may touch it
};

struct Scene {
  std::vector<Link> links;
  std::vector<Obstacle> obstacles;
  std::vector<Body> bodies;
  double clearance = 0;  ///< least distance between all bodies that may not touch [m]
  /// Pairs of bodies that are always too near (inseparableBodies()), as indices with the smaller first: not judged, but
  /// reported.
  std::vector<std::pair<int, int>> inseparable = {};
};

/// A fault of a scene. `path` names its place (`obstacle mezzanine: allow`).
struct SceneProblem {
  std::string path;
  std::string found;          ///< value found; without an expected one, a sentence of what is wrong
  std::string expected = {};  ///< value expected; empty unless a value is wrong
};

/// Returns every problem of a scene: repeated or missing names, a link that the arm lacks, a shape missing or unfit for
/// a body, an `allow` that names nothing, a clearance that is negative or not finite. Empty: the scene is usable.
[[nodiscard]] std::vector<SceneProblem> findSceneProblems(const Scene& scene);

/// Returns the name of a body in reports: its own or its link's.
[[nodiscard]] const std::string& bodyLabel(const Body& body);

/// Return true if the two may touch by the `allow` list of either.
[[nodiscard]] bool mayTouch(const Obstacle& obstacle, const Body& body);
[[nodiscard]] bool mayTouch(const Body& a, const Body& b);

/// Returns true if two bodies, by their indices, are judged against one another unless they may touch. Bodies on one
/// piece or at a common joint are not, because they always touch, nor are inseparable ones. Rows that do not move are
/// one piece with the row before them.
[[nodiscard]] bool areJudged(const Scene& scene, int a, int b);

}  // namespace tubeplan::planner
