// How far the arm, bent by its weight and load, is from what it must not touch.
#pragma once

#include <memory>

#include "deflection/row_placing.hpp"
#include "planner/collision/clearance.hpp"
#include "planner/collision/padding.hpp"
#include "planner/collision/travel_bound.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::planner {

class NearestPairs;
struct NearestPair;

/// The tool may enter holes only while it approaches or retreats; in between it keeps off the sheet as everything does.
enum class ContactRule { kTravel, kApproach };

/// How far any body point can travel, deflection's change included (deflection_travel.hpp). Where that is not proved,
/// the most seen over sampled postures stands in.
struct ArmTravel {
  TravelBound bound;
  double jump = 0;  ///< m, taken off every margin
  bool is_proved = false;
  std::string reason;  ///< why not
};
[[nodiscard]] ArmTravel armTravelOf(const Workcell& cell, const std::vector<double>& body_reach);

/// Joint values of many postures [rad, m], one column for each.
using PostureColumns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The margins of many postures, and all that is known of the tightest one (one whose margin is NaN, if there is one).
struct MarginsSideBySide {
  std::vector<double> margins;  ///< m
  std::size_t tightest = 0;
  Clearance clearance;
};

/// Clearance of postures of one workcell. Const use from several threads is safe.
class ArmClearance {
 public:
  /// `padding`: standard deviations of the base's place that are taken off every distance from what stands in the
  /// world, as each body feels them in each posture.
  explicit ArmClearance(const Workcell& cell, double padding = 0);
  ~ArmClearance();

  [[nodiscard]] const BasePadding& padding() const { return padding_; }

  /// Least margin at joint readings q, on the deflected shape; the bow of a bent member between its frames is taken
  /// off. A shape that does not converge has a NaN margin, with the reason in `other`.
  [[nodiscard]] Clearance at(const Eigen::VectorXd& q, ContactRule rule) const;

  /// The same with `spare` [m] taken off the margin: what a plan keeps in hand, so that a proof by other means succeeds
  /// too.
  [[nodiscard]] Clearance withSpare(const Eigen::VectorXd& q, ContactRule rule, double spare) const;

  /// The same of many postures, at least one, as many side by side as the processor has lanes: bit for bit what each
  /// has alone.
  [[nodiscard]] MarginsSideBySide together(const PostureColumns& q, ContactRule rule) const;

  /// Bound on any body point's travel, deflection's change included.
  [[nodiscard]] const TravelBound& travel() const { return travel_.bound; }

  /// Whether that bound is proved, and why not.
  [[nodiscard]] const ArmTravel& armTravel() const { return travel_; }

  [[nodiscard]] const Workcell& cell() const { return cell_; }

 private:
  struct PreparedArms;

  void find(const NearestPairs& pairs, const deflection::PlacedRows& placed, std::span<NearestPair> found) const;
  [[nodiscard]] Clearance lessBow(Clearance clearance, double bow) const;

  const Workcell& cell_;
  BasePadding padding_;
  std::unique_ptr<PreparedArms> arms_;  ///< the scenes by rule, and an arm for each thread that asks
  ArmTravel travel_;
};

/// How much faster than its rigid lever a point can move because the deflection changes with the joints: the most seen
/// of the tip over a lattice of postures under this load, with a tenth on top; at least 1.1. Sampled, not proved.
[[nodiscard]] double deflectionFactor(const Workcell& cell);

/// Poses of the rows' bodies in the world: each row's frame, turned so that its member lies along the bent member's
/// chord.
std::vector<Eigen::Isometry3d> bodyFrames(const Workcell& cell, const Eigen::VectorXd& q, double* bow);

}  // namespace tubeplan::planner
