// Where the arm's bodies are, bent by weight and load: many postures at a time, as many side by side as the processor
// has lanes.
//
// An arm whose shape a deflection kernel solves is placed by a kernel too; any other posture by posture. Either way a
// posture's frames are the same bits whatever its neighbours and whatever the processor.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "deflection/posture_batch.hpp"
#include "planner/collision/kernels/kernels.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::planner {

/// Postures side by side: as many as `kernel` has lanes, of which the first `count` were asked for and the others are
/// the last of these again.
struct PlacedPostures {
  const kernels::Kernel* kernel = nullptr;
  int count = 0;
  std::vector<double> frames;      ///< 12 numbers for each row, in lanes: its frame in the world (kernels::PlacedRows)
  std::vector<double> bow;         ///< m, greatest distance of a bent member from its chord
  std::vector<bool> is_converged;  ///< whether the deflected shape does; if not, nothing else is told

  [[nodiscard]] Eigen::Isometry3d X_WL(int row, int lane) const;
};

/// Places the bodies of one cell; each thread needs its own.
class BodyPlacing {
 public:
  /// `cell` must outlive this, and stay as it is.
  explicit BodyPlacing(const Workcell& cell);
  ~BodyPlacing();

  [[nodiscard]] const Workcell& cell() const { return cell_; }

  /// Whether a kernel places the arm's bodies.
  [[nodiscard]] bool hasKernel() const { return plain_ != nullptr; }

  /// The most that are placed at once.
  [[nodiscard]] int lanes() const;

  /// The postures first, first + 1, ... of those given (columns, joint values in rad), at most `lanes()` of them. Valid
  /// until the next call.
  const PlacedPostures& place(const deflection::Side& q, Eigen::Index first);
  const PlacedPostures& place(const Eigen::VectorXd& q);

 private:
  struct Plain;

  const PlacedPostures& run(int count);
  void runKernel();
  void runOneByOne();

  const Workcell& cell_;
  Eigen::Vector3d gravity_B_;
  deflection::PreparedArm arm_;
  std::unique_ptr<const Plain> plain_;  ///< the arm for the kernels; null where it is none for them
  std::vector<double> q_, load_, tip_, turns_, element_states_, sweeps_;  ///< in lanes
  PlacedPostures placed_;
};

}  // namespace tubeplan::planner
