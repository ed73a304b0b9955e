// Clearance of the arm, deflected by its weight and load, from every obstacle and body that it must not touch.
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

/// Rule for contact between tool and sheet. The tool may enter holes only during approach and retreat; during travel
/// between tubes it must keep clear of the sheet, like any other body.
enum class ContactRule { kTravel, kApproach };

/// Bound on the travel of any body point while joints move, including changes of the deflection
/// (deflection_travel.hpp). If these changes have no proved bound, a factor estimated from sampled postures is used
/// instead (deflectionFactor()).
struct ArmTravel {
  TravelBound bound;
  double jump = 0;  ///< distance that a point may jump because of joint play, subtracted from every margin [m]
  bool is_proved = false;
  std::string reason;  ///< reason why the bound is not proved; empty if the bound is proved
};
[[nodiscard]] ArmTravel armTravelOf(const Workcell& cell, const std::vector<double>& body_reach);

/// Joint values of many postures [rad, m], one column per posture.
using PostureColumns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Margins of many postures, and the full clearance of the worst one: a posture with a NaN margin or, if there is none,
/// the posture with the smallest margin.
struct MarginsSideBySide {
  std::vector<double> margins;  ///< margin of each posture [m]
  std::size_t tightest = 0;
  Clearance clearance;
};

/// Computes the clearance of the arm in any posture in one workcell. Const use from several threads is safe.
class ArmClearance {
 public:
  /// `padding` is a number of standard deviations of the base pose. They are propagated to each body in each posture,
  /// and subtracted from its distances to fixed obstacles.
  explicit ArmClearance(const Workcell& cell, double padding = 0);
  ~ArmClearance();

  [[nodiscard]] const BasePadding& padding() const { return padding_; }

  /// Returns the clearance of the deflected arm at joint values q, reduced by the bow of bent members between their
  /// frames. If the deflected shape does not converge, the margin is NaN and `other` states the reason.
  [[nodiscard]] Clearance at(const Eigen::VectorXd& q, ContactRule rule) const;

  /// Returns the clearance with `spare` [m] subtracted from the margin. The planner keeps this reserve so that the
  /// independent plan check also succeeds.
  [[nodiscard]] Clearance withSpare(const Eigen::VectorXd& q, ContactRule rule, double spare) const;

  /// Returns the margins of one or more postures, computed side by side in the SIMD lanes of the processor. Each margin
  /// has the same bits as if its posture were computed alone.
  [[nodiscard]] MarginsSideBySide together(const PostureColumns& q, ContactRule rule) const;

  /// Returns the bound on the travel of any body point, including changes of the deflection.
  [[nodiscard]] const TravelBound& travel() const { return travel_.bound; }

  /// Returns the bound on travel, and whether it is proved or the reason why not.
  [[nodiscard]] const ArmTravel& armTravel() const { return travel_; }

  [[nodiscard]] const Workcell& cell() const { return cell_; }

 private:
  struct PreparedArms;

  void find(const NearestPairs& pairs, const deflection::PlacedRows& placed, std::span<NearestPair> found) const;
  [[nodiscard]] Clearance reducedByBow(Clearance clearance, double bow) const;

  const Workcell& cell_;
  BasePadding padding_;
  std::unique_ptr<PreparedArms> arms_;  ///< prepared scenes of both contact rules, and an arm for each calling thread
  ArmTravel travel_;
};

/// Returns the factor by which a point may move faster than on a rigid arm, because the deflection changes with the
/// joints. The factor is the largest ratio of the tip's speeds over a lattice of postures, with the excess over 1
/// increased by 10 %; at least 1.1. It is an estimate from samples, not a proved bound.
[[nodiscard]] double deflectionFactor(const Workcell& cell);

/// Returns the poses of the rows' bodies in the world: each row's frame, turned so that its member lies along the chord
/// of the bent member. Empty if the deflected shape does not converge. `bow` receives the largest distance of a bent
/// member from its chord [m]; may be null.
std::vector<Eigen::Isometry3d> bodyFrames(const Workcell& cell, const Eigen::VectorXd& q, double* bow);

}  // namespace tubeplan::planner
