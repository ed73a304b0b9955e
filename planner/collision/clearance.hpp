// How far the arm is from what it must not touch, in one posture.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "planner/scene/scene.hpp"

namespace tubeplan::planner {

/// The nearest approach in one posture.
struct Clearance {
  /// m; a lower value of the true distance, negative where things overlap. Infinite where there is nothing to touch.
  double distance = std::numeric_limits<double>::quiet_NaN();
  /// m; distance less what the scene requires. Free means zero or more; NaN means it could not be computed, and is not
  /// free.
  double margin = std::numeric_limits<double>::quiet_NaN();
  std::string body;   ///< the arm's body that comes nearest
  std::string other;  ///< to this obstacle, or other body
  Eigen::Vector3d point_W = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());  ///< of the body
};

/// "forearm is 0.0021 m from divider, 0.0064 m required" [m].
[[nodiscard]] std::string describe(const Clearance& clearance);

struct PairClearance {
  Clearance clearance;
  bool allowed = false;  ///< may touch: does not count in the scene's clearance; its margin is infinite
};

/// A scene made ready for many questions. All questions are const and may be asked from several threads at once.
class CollisionWorld {
 public:
  /// The scene must be free of problems (findSceneProblems).
  explicit CollisionWorld(Scene scene);

  /// The pair with the least margin, the links' frames being at X_WL (one per link of the scene, deflected or not).
  /// Pairs that may touch are left out. Once a margin below `stop_below` [m] is found that pair is returned, though it
  /// may not be the least.
  [[nodiscard]] Clearance closest(std::span<const Eigen::Isometry3d> X_WL,
                                  double stop_below = -std::numeric_limits<double>::infinity()) const;

  /// Every pair, allowed ones included (bodies that share a joint excluded), nearest first.
  [[nodiscard]] std::vector<PairClearance> allPairs(std::span<const Eigen::Isometry3d> X_WL) const;

  /// Greatest distance of any body point of a link from the origin of its frame [m], one per link; 0 without bodies.
  [[nodiscard]] const std::vector<double>& bodyReach() const { return body_reach_; }

  [[nodiscard]] const Scene& scene() const { return scene_; }

 private:
  struct Pair {
    int body;
    int other;  ///< an obstacle's index, or a body's
    bool with_body;
    const Solid* solid;  ///< of the other; null where that is a region or a mesh
  };
  struct Placed;  ///< the bodies in one posture

  void addPair(const Pair& pair, bool allowed);
  [[nodiscard]] bool isQuick(const Pair& pair) const;
  [[nodiscard]] Placed place(std::span<const Eigen::Isometry3d> X_WL) const;
  [[nodiscard]] bool isFarther(const Pair& pair, const Placed& placed, double distance) const;
  [[nodiscard]] Separation pairSeparation(const Pair& pair, const Placed& placed) const;
  [[nodiscard]] Clearance named(const Pair& pair, const Separation& separation) const;
  [[nodiscard]] std::optional<Clearance> findLostBody(std::span<const Eigen::Isometry3d> X_WL) const;

  Scene scene_;
  std::vector<const Solid*> solids_;  ///< one per body
  std::vector<Pair> pairs_;           ///< that must keep clear
  std::vector<Pair> allowed_pairs_;
  std::vector<double> body_reach_;
};

}  // namespace tubeplan::planner
