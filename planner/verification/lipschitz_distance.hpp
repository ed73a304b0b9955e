// Clearance by another method than the planner's: it only uses the distance of a point from a shape.
//
// A point that moves by h changes its distance by at most h, so the least distance along a capsule's axis is found to
// any accuracy by halving the axis where it could still be less (Piyavskii 1972). Short and without special cases, for
// checking. Boxes and other solids of the arm are first replaced by the capsule around them; only if that is
// not clear is the solid itself tested, by a pair of separating planes.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "planner/collision/padding.hpp"

namespace tubeplan::planner {

/// Accuracy of the distance. The result is never above the true distance.
struct LipschitzOptions {
  double accuracy = 1e-6;  ///< largest error below the true distance [m]
  double share = 0;     ///< alternative error, as a share of the distance beyond `required`; the larger of both applies
  double required = 0;  ///< [m]
  /// Distance above which any lower bound of at least this is sufficient [m].
  double enough = std::numeric_limits<double>::infinity();
};

/// Returns a lower bound of the distance between a capsule and a shape [m]; `capsule` is in the shape's frame.
[[nodiscard]] double lipschitzDistance(const Capsule& capsule, const Shape& shape,
                                       const LipschitzOptions& options = {});

/// The margins of one scene's postures; the pairs that may not touch are found once. Each thread needs its own.
class LipschitzMargins {
 public:
  /// `scene` must outlive this object, and must not change. `padding` is subtracted from every distance to fixed
  /// obstacles.
  explicit LipschitzMargins(const Scene& scene, const BasePadding& padding = {});

  /// Returns a lower bound of the least margin (distance less the scene's clearance) of all pairs that may not touch,
  /// with the rows' bodies at X_WL [m]; `accuracy` and `share` (of the margin) as in LipschitzOptions. `names` receives
  /// the tightest pair, "tool, divider"; it may be null.
  double at(std::span<const Eigen::Isometry3d> X_WL, double accuracy, double share, std::string* names);

 private:
  struct Pair {
    std::size_t body, other;
    bool with_body;
  };
  /// First estimate of a pair, from the middle of the capsule.
  struct Look {
    const Pair* pair;
    Capsule capsule;  ///< capsule in the other's frame
    const Shape* other;
    double padding;  ///< padding to subtract from the distance [m]
    double bound;    ///< lower bound of the remaining margin [m]
  };

  [[nodiscard]] Look lookAt(const Pair& pair, std::span<const Eigen::Isometry3d> X_WL) const;
  [[nodiscard]] double gapOf(const Look& look, std::span<const Eigen::Isometry3d> X_WL) const;

  const Scene& scene_;
  BasePadding padding_;
  std::vector<Pair> pairs_;
  std::vector<Look> looks_;
};

}  // namespace tubeplan::planner
