// Clearance by another way than the planner's: nothing is known of a shape but how far a point is from it.
//
// A point that moves by h changes its distance by at most h, so the least distance along a capsule's axis is found to
// any accuracy by halving the axis where it could still be less (Piyavskii 1972). Short and without special cases: for
// checking. What the arm carries of boxes and other solids is first taken for the capsule around it; only where that is
// not clear is the solid itself asked for, as far as two planes prove it to be apart.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "planner/collision/padding.hpp"

namespace tubeplan::planner {

/// What is good enough. Whatever is asked, the answer is never above the true distance.
struct LipschitzOptions {
  double accuracy = 1e-6;  ///< m below the true distance, at most ...
  double share = 0;        ///< ... or this share of what the distance has beyond `required`, where that is more
  double required = 0;     ///< m
  double enough = std::numeric_limits<double>::infinity();  ///< m; beyond this any lower bound of at least this will do
};

/// A lower bound of the distance between a capsule and a shape [m]; `capsule` in the shape's frame.
[[nodiscard]] double lipschitzDistance(const Capsule& capsule, const Shape& shape,
                                       const LipschitzOptions& options = {});

/// The margins of one scene's postures; which pairs may not touch is found once. Each thread needs its own.
class LipschitzMargins {
 public:
  /// `scene` must outlive this, and stay as it is. `padding` is taken off every distance from what stands in the world.
  explicit LipschitzMargins(const Scene& scene, const BasePadding& padding = {});

  /// Lower bound of the least margin (distance less the scene's clearance) of all pairs that may not touch, the rows'
  /// bodies being at X_WL [m]; `accuracy` and `share` (of the margin) as above. `names` gets the tightest pair, "tool,
  /// divider"; it may be null.
  double at(std::span<const Eigen::Isometry3d> X_WL, double accuracy, double share, std::string* names);

 private:
  struct Pair {
    std::size_t body, other;
    bool with_body;
  };
  /// What one look at the capsule's middle shows of a pair.
  struct Look {
    const Pair* pair;
    Capsule capsule;  ///< in the other's frame
    const Shape* other;
    double padding;  ///< m, taken off the distance
    double bound;    ///< m, lower bound of what is left
  };

  [[nodiscard]] Look lookAt(const Pair& pair, std::span<const Eigen::Isometry3d> X_WL) const;
  [[nodiscard]] double gapOf(const Look& look, std::span<const Eigen::Isometry3d> X_WL) const;

  const Scene& scene_;
  BasePadding padding_;
  std::vector<Pair> pairs_;
  std::vector<Look> looks_;
};

}  // namespace tubeplan::planner
