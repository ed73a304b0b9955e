// Torsional stiffness at a joint or bearing.
//
// Law: theta_k = M_k / K_k about each axis k = x, y, z of the row's frame (Calkins 1994, eq. 2.17, section 2.3.3).
//      With an addition: theta_k = (M_k + s_k clamp(M_k, -M1_k, M1_k)) / K_k + c_k M_k, the soft zone of a harmonic
//      drive below the knee M1 (Harmonic Drive, torsional stiffness K1, K2), and a compliance c of a rigid axis.
// Symbols: M moment about the row's origin [N m], K stiffness [N m/rad], theta rotation [rad], s softness of the zone
//      (its stiffness is K/(1+s)), M1 its knee [N m], c compliance [rad/(N m)].
// Validity: elastic, no friction; clearance is clearance.hpp. An infinite K is a rigid axis.
#pragma once

#include <cmath>

#include "deflection/elements/element.hpp"

namespace tubeplan::deflection::joint_stiffness {

inline bool isFlexible(const Row<double>& row) {
  return row.joint_stiffness.array().isFinite().any() || (row.addition && row.addition->joint_gives);
}

inline int segments(const Row<double>&) { return 1; }

template <class S>
S clampTo(const S& x, const S& limit) {
  return x > limit ? limit : x < -limit ? S(-limit) : x;
}

template <class S>
Vector3<S> addedRotation(const Row<S>& row, const Vector3<S>& moment) {
  const Addition<S>& addition = *row.addition;
  Vector3<S> rotation = moment.cwiseProduct(addition.compliance);
  for (int k = 0; k < 3; ++k)
    if (std::isfinite(valueOf(row.joint_stiffness[k])))
      rotation[k] += addition.softness[k] * clampTo<S>(moment[k], addition.knee[k]) / row.joint_stiffness[k];
  return rotation;
}

template <class S>
Deflection<S> deflect(const Row<S>& row, const Loading<S>& loading) {
  Deflection<S> result;
  for (int k = 0; k < 3; ++k)
    if (std::isfinite(valueOf(row.joint_stiffness[k]))) result.rotation[k] = loading.moment[k] / row.joint_stiffness[k];
  if (row.addition && row.addition->joint_gives) result.rotation += addedRotation<S>(row, loading.moment);
  return result;
}

}  // namespace tubeplan::deflection::joint_stiffness
