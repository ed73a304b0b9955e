// The two sweeps over the flattened arm: outwards for the frames, inwards for the loads and the deflections they cause.
#pragma once

#include <vector>

#include "deflection/chain.hpp"
#include "deflection/elements/clearance.hpp"

namespace tubeplan::deflection {

/// Far frames of all links, `frames[0]` the base; without any deflection where `rigid`.
void combineTransforms(const Chain<double>& chain, bool rigid, std::vector<PoseOf<double>>& frames);

/// How everything beyond a place pulls back when it is turned about it, and how hard at most. It steers the clearances.
struct Restoring {
  Eigen::Matrix3d virial = Eigen::Matrix3d::Zero();  ///< sum of r F^T, r from the place to the force [N m], base axes
  double forces = 0;                                 ///< sum of the forces' sizes [N]

  void add(const Eigen::Vector3d& r, const Eigen::Vector3d& force);

  /// Change of the moment about n with a turn about n: n . sum (n x r) x F.
  [[nodiscard]] double momentPerAngle(const Eigen::Vector3d& n) const;
};

/// What everything beyond a place does to it, about that place, in base axes.
struct Load {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< N m
  Restoring restoring;
};

/// One inward sweep: what it reads of the arm, and the load that it carries, from the tip to the base.
struct InwardSweep {
  const Arm& arm;
  const Posture& posture;
  double reach;
  int clearances;
  Load carry;
};

/// A sweep that starts at the tip, with the hung load and what effects add there.
InwardSweep beginAtTip(const Arm& arm, const Posture& posture, double reach, int clearances, const PoseOf<double>& tip);

/// What the carried load, still at the link's far frame, does to the link's element.
Loading<double> loadingOf(const InwardSweep& sweep, const PoseOf<double>& near, const PoseOf<double>& far,
                          const ChainLink<double>& link);

/// Where an axis of a joint rests within its clearance, under the moment about it.
clearance::Rest restOf(const InwardSweep& sweep, const ChainLink<double>& link, int axis, const PoseOf<double>& near,
                       double before, double moment);

/// Moves the carried load from a link's far frame to its near frame and deflects the link's element on the way (steps 3
/// and 4 of the thesis's table 2.1).
void resolveLink(InwardSweep& sweep, const PoseOf<double>& near, const PoseOf<double>& far,
                 const ChainLink<double>& link, std::vector<ComponentState>& components);

}  // namespace tubeplan::deflection
