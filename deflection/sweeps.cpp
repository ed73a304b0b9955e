#include "deflection/sweeps.hpp"

namespace tubeplan::deflection {

using Eigen::Vector3d;

void combineTransforms(const Chain<double>& chain, bool rigid, std::vector<PoseOf<double>>& frames) {
  frames.resize(chain.links.size() + 1);
  frames[0] = {};
  for (std::size_t k = 0; k < chain.links.size(); ++k) {
    const ChainLink<double>& link = chain.links[k];
    PoseOf<double> X = frames[k];
    Vector3d p = link.p;
    if (!rigid && link.component >= 0) p += chain.components[link.component].displacement;
    X.p += X.R * p;
    if (link.type == ChainLinkType::kTurn) X.R = X.R * link.R;
    if (!rigid && link.component >= 0)
      X.R = X.R * rotationFromVector<double>(chain.components[link.component].rotation);
    frames[k + 1] = X;
  }
}

void Restoring::add(const Vector3d& r, const Vector3d& force) {
  virial += r * force.transpose();
  forces += force.norm();
}

double Restoring::momentPerAngle(const Vector3d& n) const { return n.dot(virial.transpose() * n) - virial.trace(); }

InwardSweep beginAtTip(const Arm& arm, const Posture& posture, double reach, int clearances,
                       const PoseOf<double>& tip) {
  InwardSweep sweep{arm, posture, reach, clearances, {}};
  Load& carry = sweep.carry;
  carry.force = posture.gravity_B * posture.load;
  Vector3d lever_B = Vector3d::Zero();
  if (arm.tip_load) {
    lever_B = tip.R * arm.tip_load->payload_offset;
    carry.moment = lever_B.cross(carry.force);
  }
  carry.restoring.add(lever_B, carry.force);
  if (!arm.tip_load) return sweep;
  const Vector3d contact_B = -arm.tip_load->contact_force * posture.gravity_B;
  carry.force += contact_B;
  carry.restoring.add(Vector3d::Zero(), contact_B);
  return sweep;
}

Loading<double> loadingOf(const InwardSweep& sweep, const PoseOf<double>& near, const PoseOf<double>& far,
                          const ChainLink<double>& link) {
  const Vector3d r_B = far.p - near.p;
  const Vector3d weight_B = sweep.posture.gravity_B * link.weight;
  const Eigen::Matrix3d R_NB = near.R.transpose();
  return {R_NB * sweep.carry.force, R_NB * sweep.carry.moment, R_NB * weight_B, link.p, R_NB * r_B};
}

clearance::Rest restOf(const InwardSweep& sweep, const ChainLink<double>& link, int axis, const PoseOf<double>& near,
                       double before, double moment) {
  const Restoring& restoring = sweep.carry.restoring;
  return clearance::settle(
      sweep.arm.rows[link.row].addition->gap[axis], before, moment,
      {restoring.momentPerAngle(near.R.col(axis)), restoring.forces * sweep.reach, sweep.clearances});
}

namespace {

void deflectElement(const InwardSweep& sweep, const PoseOf<double>& near, const PoseOf<double>& far,
                    const ChainLink<double>& link, ComponentState& component) {
  const Row<double>& row = sweep.arm.rows[link.row];
  const Loading<double> loading = loadingOf(sweep, near, far, link);
  const Deflection<double> deflection = elementKinds()[component.kind].deflect(row, loading);
  component.displacement = deflection.displacement;
  component.rotation = deflection.rotation;
  if (link.type != ChainLinkType::kFlexJoint || !row.addition) return;
  for (int k = 0; k < 3; ++k)
    if (row.addition->has_gap[k])
      component.gap[k] = restOf(sweep, link, k, near, component.gap[k], loading.moment[k]).angle;
  component.rotation += component.gap;
}

/// Moves what pulls back from a link's far frame to its near frame; before the load itself is moved.
void carryRestoring(Load& carry, const Row<double>& row, const PoseOf<double>& near, const ChainLink<double>& link,
                    const Vector3d& r_B, const Vector3d& weight_B) {
  carry.restoring.virial += r_B * carry.force.transpose();
  const bool hangs_aside = link.type == ChainLinkType::kLump;
  carry.restoring.add(hangs_aside ? Vector3d(near.R * link.lever) : Vector3d(r_B / 2), weight_B);
  if (link.type == ChainLinkType::kEndWeight && row.addition) carry.restoring.add(Vector3d::Zero(), row.addition->pull);
}

}  // namespace

void resolveLink(InwardSweep& sweep, const PoseOf<double>& near, const PoseOf<double>& far,
                 const ChainLink<double>& link, std::vector<ComponentState>& components) {
  const Row<double>& row = sweep.arm.rows[link.row];
  Load& carry = sweep.carry;
  const Vector3d r_B = far.p - near.p;
  const Vector3d weight_B = sweep.posture.gravity_B * link.weight;
  if (link.component >= 0) deflectElement(sweep, near, far, link, components[link.component]);
  if (sweep.clearances > 0) carryRestoring(carry, row, near, link, r_B, weight_B);
  carry.moment += r_B.cross(carry.force) + (r_B / 2).cross(weight_B);
  carry.force += weight_B;
  if (link.type == ChainLinkType::kLump) carry.moment += (near.R * link.lever).cross(weight_B);
  if (link.type == ChainLinkType::kEndWeight && row.addition) carry.force += row.addition->pull;
}

}  // namespace tubeplan::deflection
