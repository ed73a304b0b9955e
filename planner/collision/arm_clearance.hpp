// Clearance of the arm, bent by its weight and load, from everything that it must not touch.
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

/// Rule for the tool at the sheet: it may enter holes only while it approaches or retreats; in a travel it keeps clear
/// of the sheet like every body.
enum class ContactRule { kTravel, kApproach };

/// Bound on the travel of any body point, including changes of the deflection (deflection_travel.hpp). If that is not
/// proved, the largest change over sampled postures replaces it.
struct ArmTravel {
  TravelBound bound;
  double jump = 0;  ///< distance subtracted from every margin [m]
  bool is_proved = false;
  std::string reason;  ///< reason if not proved
};
[[nodiscard]] ArmTravel armTravelOf(const Workcell& cell, const std::vector<double>& body_reach);

/// Joint values of many postures [rad, m], one column for each.
using PostureColumns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The margins of many postures, and the full clearance of the tightest one (or of one with a NaN margin, if there is
/// any).
struct MarginsSideBySide {
  std::vector<double> margins;  ///< [m]
  std::size_t tightest = 0;
  Clearance clearance;
};

/// Clearance of postures of one workcell. Const use from several threads is safe.
class ArmClearance {
 public:
  /// `padding`: number of standard deviations of the base's place to subtract from every distance to fixed obstacles,
  /// propagated to each body in each posture.
  explicit ArmClearance(const Workcell& cell, double padding = 0);
  ~ArmClearance();

  [[nodiscard]] const BasePadding& padding() const { return padding_; }

  /// Returns the least margin at joint readings q, on the deflected shape, less the bow of bent members between their
  /// frames. A shape that does not converge has a NaN margin, with the reason in `other`.
  [[nodiscard]] Clearance at(const Eigen::VectorXd& q, ContactRule rule) const;

  /// Returns the clearance with `spare` [m] subtracted from the margin: a plan's reserve, so that a proof by another
  /// method succeeds too.
  [[nodiscard]] Clearance withSpare(const Eigen::VectorXd& q, ContactRule rule, double spare) const;

  /// Returns the margins of one or more postures, computed as many side by side as the processor has lanes. Each has
  /// the same bits as alone.
  [[nodiscard]] MarginsSideBySide together(const PostureColumns& q, ContactRule rule) const;

  /// Returns the bound on any body point's travel, including changes of the deflection.
  [[nodiscard]] const TravelBound& travel() const { return travel_.bound; }

  /// Returns the bound with its proof, or the reason why it is not proved.
  [[nodiscard]] const ArmTravel& armTravel() const { return travel_; }

  [[nodiscard]] const Workcell& cell() const { return cell_; }

 private:
  struct PreparedArms;

  void find(const NearestPairs& pairs, const deflection::PlacedRows& placed, std::span<NearestPair> found) const;
  [[nodiscard]] Clearance lessBow(Clearance clearance, double bow) const;

  const Workcell& cell_;
  BasePadding padding_;
  std::unique_ptr<PreparedArms> arms_;  ///< the scenes by rule, and an arm for each calling thread
  ArmTravel travel_;
};

/// Returns the ratio of a point's speed to its speed on a rigid arm, because the deflection changes with the joints. It
/// is the largest for the tip over a lattice of postures under this load, with a margin of a tenth; at least 1.1.
/// Sampled, not proved.
[[nodiscard]] double deflectionFactor(const Workcell& cell);

/// Returns the poses of the rows' bodies in the world: each row's frame, turned so that its member lies along the bent
/// member's chord. `bow` receives the greatest distance of a bent member from its chord [m]; it may be null.
std::vector<Eigen::Isometry3d> bodyFrames(const Workcell& cell, const Eigen::VectorXd& q, double* bow);

}  // namespace tubeplan::planner
