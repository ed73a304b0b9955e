// Placement of the rows of an arm bent by weight and load, each turned along its bent member's chord. Bodies are
// fixed to these frames. Many postures at a time, as many side by side as the processor has lanes.
//
// A posture's frames are the same bits whatever its neighbours and whatever the processor, and whether or not a
// kernel takes the arm.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "deflection/posture_batch.hpp"
#include "deflection/prepared_arm.hpp"

namespace tubeplan::deflection {

/// Rows of postures side by side: `lanes` of them. The first `count` were asked for; the others repeat the last of
/// these.
struct PlacedRows {
  int lanes = 0;
  int count = 0;
  /// 12 numbers for each row, in lanes: its frame in the world, laid out as poses in TipBatch.
  std::vector<double> frames;
  std::vector<double> bow;         ///< greatest distance of a bent member from its chord [m]
  std::vector<bool> is_converged;  ///< false: the deflected shape does not converge, and frames and bow are invalid

  [[nodiscard]] Eigen::Isometry3d X_WL(int row, int lane) const;
};

/// Places the rows of one arm under one load; each thread needs its own.
class RowPlacing {
 public:
  /// `arm` must outlive this object, and must not change. `load` [N] hangs on the tip.
  RowPlacing(const Arm& arm, double load, const Eigen::Isometry3d& X_WB);
  ~RowPlacing();

  /// Returns the largest number of postures placed at once.
  [[nodiscard]] int lanes() const;

  /// Places the postures `first`, `first` + 1, ... of those given (columns, joint values in rad or m), at most lanes()
  /// of them. The result is valid until the next call.
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
  std::unique_ptr<const Plain> plain_;  ///< the arm for the kernels; null if they do not take it
  /// Inputs and outputs of the kernel, in lanes.
  std::vector<double> q_, loads_, tip_, turns_, element_states_, sweeps_;
  PlacedRows placed_;
};

}  // namespace tubeplan::deflection
