// Frames of the rows of an arm that is bent by its weight and load; each frame is rotated so that the row's undeflected
// member lies along the bent member's chord. Collision bodies are fixed to these frames. As many postures are placed at
// once as the processor has SIMD lanes.
//
// The frames of a posture are bit-identical on every processor, with or without a kernel, regardless of the postures in
// the other lanes.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "deflection/posture_batch.hpp"
#include "deflection/prepared_arm.hpp"

namespace tubeplan::deflection {

/// Placed rows of `lanes` postures side by side. The first `count` postures were requested; the remaining lanes repeat
/// the last requested posture.
struct PlacedRows {
  int lanes = 0;
  int count = 0;
  /// 12 values for each row, in lanes: the row's frame in the world, laid out like TipBatch::poses.
  std::vector<double> frames;
  std::vector<double> bow;         ///< for each lane, largest distance of a bent member from its chord [m]
  std::vector<bool> is_converged;  ///< false if the deflected shape does not converge, and frames and bow are invalid

  [[nodiscard]] Eigen::Isometry3d X_WL(int row, int lane) const;
};

/// Places the rows of one arm under one load; each thread needs its own object.
class RowPlacing {
 public:
  /// `arm` must outlive this object, and must not change. `load` [N] hangs on the tip.
  RowPlacing(const Arm& arm, double load, const Eigen::Isometry3d& X_WB);
  ~RowPlacing();

  /// Returns the largest number of postures placed at once.
  [[nodiscard]] int lanes() const;

  /// Places the postures in columns `first`, `first` + 1, ... of `q` (joint values in rad or m), at most lanes() of
  /// them. The result is valid until the next call.
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
  std::unique_ptr<const Plain> plain_;  ///< the arm in kernel form; null if no kernel can place it
  /// Inputs and outputs of the kernel, in lanes.
  std::vector<double> q_, loads_, tip_, turns_, element_states_, sweeps_;
  PlacedRows placed_;
};

}  // namespace tubeplan::deflection
