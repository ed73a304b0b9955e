// The scene as data: obstacles in the world, bodies of the links, and permitted contacts.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "planner/scene/scene_shapes.hpp"

namespace tubeplan::planner {

/// A row of the arm; `Scene::links` has all rows, in order from the base. A passive row does not move: it forms one
/// rigid part with the row before it.
struct Link {
  std::string name;
  bool moves = true;
};

/// An obstacle fixed in the world: a solid to avoid, or a region to stay in.
struct Obstacle {
  std::string name;
  ShapePointer shape;
  std::vector<std::string> allow;  ///< names of links or bodies that may touch the obstacle
};

/// A solid carried by a link, in the link's own frame.
struct Body {
  std::string link;
  int frame_index = -1;            ///< index of the link in Scene::links, and of its pose in arrays of link poses
  std::string name;                ///< name in reports; if empty, the link's name is used
  ShapePointer shape;              ///< shape of the body; must be a Solid
  std::vector<std::string> allow;  ///< names of obstacles, links or bodies that may touch this body
};

struct Scene {
  std::vector<Link> links;
  std::vector<Obstacle> obstacles;
  std::vector<Body> bodies;
  double clearance = 0;  ///< smallest permitted distance [m] of a body from anything that it may not touch
  /// Pairs of bodies that are too close in every posture (inseparableBodies()), as indices into `bodies`, the smaller
  /// first. They are reported, but not checked.
  std::vector<std::pair<int, int>> inseparable = {};
};

/// An error in a scene. `path` names the field with the error (`obstacle mezzanine: allow`).
struct SceneProblem {
  std::string path;
  std::string found;          ///< value found; if `expected` is empty, a sentence that states the problem
  std::string expected = {};  ///< value expected; empty unless a value is wrong
};

/// Returns every problem of a scene: repeated or missing names, a body on a link that the arm lacks, a shape that is
/// missing or unfit for a body, an unknown name in `allow`, a clearance that is negative or not finite. An empty result
/// means that the scene is usable.
[[nodiscard]] std::vector<SceneProblem> findSceneProblems(const Scene& scene);

/// Returns the name of a body in reports: the body's own name or, if empty, the link's name.
[[nodiscard]] const std::string& bodyLabel(const Body& body);

/// Return true if contact is permitted by the `allow` list of the obstacle or the body, or of one of the two bodies.
[[nodiscard]] bool mayTouch(const Obstacle& obstacle, const Body& body);
[[nodiscard]] bool mayTouch(const Body& a, const Body& b);

/// Returns true if two bodies, given by index, are checked against each other unless they may touch. Inseparable pairs
/// are not checked, nor are bodies on one rigid part or on the two sides of a single joint, because these always touch.
/// Rows that do not move form one rigid part with the row before them.
[[nodiscard]] bool areJudged(const Scene& scene, int a, int b);

}  // namespace tubeplan::planner
