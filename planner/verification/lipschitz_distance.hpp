// Clearance computed by a different method from the planner's: it uses only the distance of a point from a shape.
//
// If a point moves by h, its distance changes by at most h. The smallest distance along a capsule's axis is therefore
// found to any accuracy by bisecting the axis where the distance could still be smaller (Piyavskii 1972). The method is
// short and has no special cases, which suits an independent check. Boxes and other solids of the arm are first
// replaced by the capsule around them; the solid itself is tested, with a pair of separating planes, only if the
// capsule is not clear.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "planner/collision/padding.hpp"

namespace tubeplan::planner {

/// Options for the accuracy of lipschitzDistance(), whose result never exceeds the true distance.
struct LipschitzOptions {
  double accuracy = 1e-6;  ///< largest amount by which the result may fall below the true distance [m]
  /// Alternative accuracy, as a fraction of the distance beyond `required`; the larger of the two applies.
  double share = 0;
  double required = 0;  ///< distance from which `share` is measured [m]
  /// A lower bound of at least `sufficient` [m] is accurate enough.
  double sufficient = std::numeric_limits<double>::infinity();
};

/// Returns a lower bound of the distance between a capsule and a shape [m]; `capsule` is in the shape's frame.
[[nodiscard]] double lipschitzDistance(const Capsule& capsule, const Shape& shape,
                                       const LipschitzOptions& options = {});

/// Computes the margins of postures in one scene. The pairs that may not touch are determined only once. Each thread
/// needs its own object.
class LipschitzMargins {
 public:
  /// `scene` must outlive this object, and must not change. `padding` is subtracted from every distance to fixed
  /// obstacles.
  explicit LipschitzMargins(const Scene& scene, const BasePadding& padding = {});

  /// Returns a lower bound of the smallest margin [m] (distance minus the scene's clearance) over all pairs that may
  /// not touch, with the rows' bodies at X_WL. `accuracy` [m] and `share` (fraction of the margin) are as in
  /// LipschitzOptions. `names` receives the tightest pair, such as "tool, divider"; may be null.
  double at(std::span<const Eigen::Isometry3d> X_WL, double accuracy, double share, std::string* names);

 private:
  struct Pair {
    std::size_t body, other;
    bool with_body;
  };
  /// First estimate of a pair's distance, from the middle of the capsule.
  struct PairEstimate {
    const Pair* pair;
    Capsule capsule;  ///< capsule in the frame of the other shape
    const Shape* other;
    double padding;  ///< padding to subtract from the distance [m]
    double bound;    ///< lower bound of the distance after the padding is subtracted [m]
  };

  [[nodiscard]] PairEstimate estimateOf(const Pair& pair, std::span<const Eigen::Isometry3d> X_WL) const;
  [[nodiscard]] double gapOf(const PairEstimate& estimate, std::span<const Eigen::Isometry3d> X_WL) const;

  const Scene& scene_;
  BasePadding padding_;
  std::vector<Pair> pairs_;
  std::vector<PairEstimate> estimates_;
};

}  // namespace tubeplan::planner
