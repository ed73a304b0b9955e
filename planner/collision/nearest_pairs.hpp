// The nearest pair of many placed postures at once: of each the one with the least margin, found side by side.
//
// Capsules are measured by kernels, from planes, spheres, boxes, cylinders and each other
// (kernels/distance_kernel.hpp). For every other pair (a mesh, an arm's body that is no capsule) a kernel gives a lower
// bound, by the capsule around the body and the box around the mesh; only where that is less than the least distance so
// far is the pair itself asked, posture by posture.
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
  double distance = std::numeric_limits<double>::quiet_NaN();  ///< m; as Clearance::distance
  int pair = -1;                                               ///< none where there is nothing to touch
};

/// A scene made ready for many questions. All questions are const and may be asked from several threads at once.
class NearestPairs {
 public:
  /// The scene must be free of problems (findSceneProblems).
  explicit NearestPairs(Scene scene);

  /// One for each posture placed; NaN where the shape does not converge or a pose is not a number.
  void find(const deflection::PlacedRows& placed, std::span<NearestPair> found) const;

  /// The same of one posture, with the padding of the base taken off every distance from what stands in the world: pair
  /// by pair, without a kernel.
  [[nodiscard]] NearestPair findPadded(const deflection::PlacedRows& placed, int lane,
                                       const BasePadding& padding) const;

  /// What `find` has found of the posture in a lane, in words, and where.
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
  std::vector<const Solid*> solids_;  ///< one per body
  std::vector<kernels::PlainBody> bodies_;
  std::vector<kernels::PlainObstacle> obstacles_;
  std::vector<kernels::PairKind> obstacle_kinds_;
  std::vector<bool> obstacle_is_plain_;    ///< the kernel has the obstacle itself, not what is around it
  std::vector<kernels::PlainPair> pairs_;  ///< first the exact ones
  int exact_ = 0;
};

}  // namespace tubeplan::planner
