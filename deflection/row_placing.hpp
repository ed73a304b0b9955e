// Where the rows of an arm are, bent by weight and load, each turned along its bent member's chord: what bodies are
// fixed to. Many postures at a time, as many side by side as the processor has lanes.
//
// A posture's frames are the same bits whatever its neighbours and whatever the processor, and whether or not the arm
// is one for the kernels.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "deflection/posture_batch.hpp"
#include "deflection/prepared_arm.hpp"

namespace tubeplan::deflection {

/// Rows of postures side by side: `lanes` of them, of which the first `count` were asked for and the others are the
/// last of these again.
struct PlacedRows {
  int lanes = 0;
  int count = 0;
  std::vector<double> frames;  ///< 12 numbers for each row, in lanes: its frame in the world, as an X_BD in TipBatch
  std::vector<double> bow;     ///< m, greatest distance of a bent member from its chord
  std::vector<bool> is_converged;  ///< whether the deflected shape does; if not, frames and bow mean nothing

  [[nodiscard]] Eigen::Isometry3d X_WL(int row, int lane) const;
};

/// Places the rows of one arm under one load; each thread needs its own.
class RowPlacing {
 public:
  /// `arm` must outlive this, and stay as it is. `load` [N] hangs on the tip.
  RowPlacing(const Arm& arm, double load, const Eigen::Isometry3d& X_WB);
  ~RowPlacing();

  /// The most that are placed at once.
  [[nodiscard]] int lanes() const;

  /// The postures first, first + 1, ... of those given (columns, joint values in rad or m), at most `lanes()` of them.
  /// Valid until the next call.
  const PlacedRows& place(const Side& q, Eigen::Index first);
  const PlacedRows& place(const Eigen::VectorXd& q);

 private:
  struct Plain;

  const PlacedRows& run(int count);
  void runKernel();
  void runOneByOne();

  const Arm& given_;
  double load_;
  Eigen::Isometry3d X_WB_;
  Eigen::Vector3d gravity_B_;
  PreparedArm arm_;
  std::unique_ptr<const Plain> plain_;  ///< the arm for the kernels; null where it is none for them
  std::vector<double> q_, loads_, tip_, turns_, element_states_, sweeps_;  ///< in lanes
  PlacedRows placed_;
};

}  // namespace tubeplan::deflection
