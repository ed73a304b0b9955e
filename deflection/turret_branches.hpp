// The rigid starts of many goals of one arm, with what no goal changes worked out once.
#pragma once

#include "deflection/rigid_branches.hpp"

namespace tubeplan::deflection {

class RigidBranches {
 public:
  /// `arm` must outlive this.
  explicit RigidBranches(const Arm& arm);

  [[nodiscard]] bool isTurret() const { return is_turret_; }
  /// Adds what turretBranches() or latticeStarts() have.
  void addStarts(const ToolGoal& goal, int lattice_starts, std::vector<Eigen::VectorXd>& starts) const;

 private:
  const Arm& arm_;
  bool is_turret_;
  std::vector<Eigen::Vector3d> points_, directions_;  ///< of the joints' axes at zero readings
  Eigen::Vector3d tip_, tool_axis_;
};

}  // namespace tubeplan::deflection
