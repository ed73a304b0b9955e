// Nearest pair, of two bodies or of a body and an obstacle, in each of many postures, found side by side.
//
// Kernels compute the distances of capsules from planes, spheres, boxes, cylinders and each other
// (kernels/distance_kernel.hpp). For every other pair (a mesh, or a body of the arm that is not a capsule) a kernel
// computes a lower bound from the capsule around the body and the box around the mesh. The distance of such a pair is
// computed, for one posture at a time, only if its lower bound is smaller than the smallest distance so far.
#pragma once

#include <span>
#include <vector>

#include "deflection/row_placing.hpp"
#include "planner/collision/clearance.hpp"
#include "planner/collision/kernels/kernels.hpp"
#include "planner/collision/padding.hpp"

namespace tubeplan::planner {

/// The pair nearest to each other in one posture, and its distance.
struct NearestPair {
  double distance = std::numeric_limits<double>::quiet_NaN();  ///< distance, as in Clearance::distance [m]
  int pair = -1;  ///< index of the nearest pair among the pairs of the scene; -1 if the scene has no pairs
};

/// A scene prepared for many queries. Queries are const, and safe from several threads at once.
class NearestPairs {
 public:
  /// `scene` must have no problems (findSceneProblems()).
  explicit NearestPairs(Scene scene);

  /// Finds the nearest pair of each placed posture; its distance is NaN if the shape does not converge or a pose is not
  /// finite.
  void find(const deflection::PlacedRows& placed, std::span<NearestPair> found) const;

  /// Finds the nearest pair of one posture, with the padding of the base subtracted from every distance to fixed
  /// obstacles. The distances are computed without a kernel.
  [[nodiscard]] NearestPair findPadded(const deflection::PlacedRows& placed, int lane,
                                       const BasePadding& padding) const;

  /// Returns the result of find() for the posture in a lane, with the names of the pair and its nearest point.
  [[nodiscard]] Clearance named(const deflection::PlacedRows& placed, int lane, const NearestPair& found) const;

  [[nodiscard]] const Scene& scene() const { return scene_; }

 private:
  void addPairs();
  [[nodiscard]] Separation separationOf(const deflection::PlacedRows& placed, int lane,
                                        const kernels::PlainPair& pair) const;
  [[nodiscard]] bool isFarther(const deflection::PlacedRows& placed, int lane, const kernels::PlainPair& pair,
                               double distance) const;
  [[nodiscard]] Capsule around(const deflection::PlacedRows& placed, int lane, int body) const;

  Scene scene_;
  std::vector<const Solid*> solids_;  ///< solid of each body
  std::vector<kernels::PlainBody> bodies_;
  std::vector<kernels::PlainObstacle> obstacles_;
  std::vector<kernels::PairKind> obstacle_kinds_;
  /// For each obstacle, true if the kernel measures the obstacle itself, false if it measures a solid around the
  /// obstacle.
  std::vector<bool> obstacle_is_plain_;
  std::vector<kernels::PlainPair> pairs_;  ///< pairs; those whose distance the kernel computes exactly come first
  int exact_ = 0;
};

}  // namespace tubeplan::planner
