// What every effect of the catalogue, and every stiffness that is off, would do to the tip: the columns of what a model
// may lack.
#pragma once

#include <memory>
#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::deflection {
class PreparedArm;
}

namespace tubeplan::calibration {

/// Each thread needs its own.
class HiddenEffects {
 public:
  /// Effects that need what a touch does not record (time, temperature, the sense of a motion) are left out, and those
  /// that the arm has already. `share`: of each plausible size, over which the difference is taken.
  HiddenEffects(const deflection::Arm& arm, double share);
  ~HiddenEffects();

  /// Of each column its kind, counted from 0.
  [[nodiscard]] const std::vector<int>& kinds() const { return kinds_; }

  /// m, world axes: what the plausible size of each does to the tip; zero where a shape does not converge.
  [[nodiscard]] Eigen::Matrix3Xd at(const Eigen::Isometry3d& X_WB, const Eigen::VectorXd& q, double load);

 private:
  void add(deflection::Arm changed, int kind, double share);

  struct Changed;                               ///< an arm with one change
  std::vector<std::unique_ptr<Changed>> arms_;  ///< the first as it is
  std::vector<int> kinds_;
};

}  // namespace tubeplan::calibration
