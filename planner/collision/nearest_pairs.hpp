// The nearest pairs of many placed postures, found side by side: for each posture the one with the least margin.
//
// Capsules are measured by kernels, from planes, spheres, boxes, cylinders and each other
// (kernels/distance_kernel.hpp). For every other pair (a mesh, an arm's body that is no capsule) a kernel gives a lower
// bound, by the capsule around the body and the box around the mesh; only if that is less than the least distance so
// far is the pair itself computed, posture by posture.
#pragma once

#include <span>
#include <vector>

#include "deflection/row_placing.hpp"
#include "planner/collision/clearance.hpp"
#include "planner/collision/kernels/kernels.hpp"
#include "planner/collision/padding.hpp"

namespace tubeplan::planner {

/// The nearest approach of one posture.
struct NearestPair {
  double distance = std::numeric_limits<double>::quiet_NaN();  ///< distance with the meaning of Clearance::distance [m]
  int pair = -1;                                               ///< -1 if there is nothing to touch
};

/// A scene prepared for many queries, which are const and safe from several threads at once.
class NearestPairs {
 public:
  /// The scene must be free of problems (findSceneProblems()).
  explicit NearestPairs(Scene scene);

  /// Finds one pair for each posture placed; NaN if the shape does not converge or a pose is not finite.
  void find(const deflection::PlacedRows& placed, std::span<NearestPair> found) const;

  /// Finds the pair of one posture, with the padding of the base subtracted from every distance to fixed obstacles.
  /// This is done pair by pair, without a kernel.
  [[nodiscard]] NearestPair findPadded(const deflection::PlacedRows& placed, int lane,
                                       const BasePadding& padding) const;

  /// Returns the result of find() for the posture in a lane, with names and point.
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
  std::vector<bool> obstacle_is_plain_;    ///< true: the kernel has the obstacle itself, not a solid around it
  std::vector<kernels::PlainPair> pairs_;  ///< the exact ones first
  int exact_ = 0;
};

}  // namespace tubeplan::planner
