// Torsional stiffness at a joint or bearing.
//
// Law: theta_k = M_k / K_k about each axis k = x, y, z of the row's frame (Calkins 1994, eq. 2.17, section 2.3.3).
//      Effects extend it to theta_k = M_k / K_k + c_k M_k + (s_k / K_k + d_k) clamp(M_k, -M1_k, M1_k): a compliance c,
//      also of an axis with infinite K, and the soft zone of a gear below the knee M1 (Harmonic Drive, torsional
//      stiffness K1, K2).
// Symbols: M moment about the row's origin [N m], K stiffness [N m/rad], theta rotation [rad], c compliance
//      [rad/(N m)], s softness of the zone (stiffness K/(1+s) there), d compliance that the zone adds [rad/(N m)],
//      M1 knee moment [N m].
// Validity: elastic, no friction; see clearance.hpp for clearance. An infinite K is a rigid axis.
#pragma once

#include <cmath>

#include "deflection/elements/element.hpp"

namespace tubeplan::deflection::joint_stiffness {

inline bool isFlexible(const Row<double>& row) {
  return row.joint_stiffness.array().isFinite().any() || (row.effect_terms && row.effect_terms->joint_is_compliant);
}

inline int segments(const Row<double>&) { return 1; }

template <class S>
S clampTo(const S& x, const S& limit) {
  return x > limit ? limit : x < -limit ? S(-limit) : x;
}

template <class S>
Flexibility<S> flexibilityOf(const Row<S>& row, const Vector3<S>&) {
  Flexibility<S> result;
  const bool added = row.effect_terms && row.effect_terms->joint_is_compliant;
  for (int k = 0; k < 3; ++k) {
    if (std::isfinite(valueOf(row.joint_stiffness[k]))) result.compliance(k, k) = S(1) / row.joint_stiffness[k];
    if (!added) continue;
    result.softness[k] = row.effect_terms->softness[k] * result.compliance(k, k) + row.effect_terms->soft_compliance[k];
    result.compliance(k, k) += row.effect_terms->compliance[k];
    result.knee[k] = row.effect_terms->knee[k];
    result.has_soft_zone = true;
  }
  return result;
}

/// Computes the deflection under a load. The scalar type `L` of the load is double if only the flexibility has
/// derivatives.
template <class S, class L>
Deflection<S> deflect(const Flexibility<S>& flexibility, const Loading<L>& loading) {
  Deflection<S> result;
  for (int k = 0; k < 3; ++k) result.rotation[k] = flexibility.compliance(k, k) * loading.moment[k];
  if (!flexibility.has_soft_zone) return result;
  for (int k = 0; k < 3; ++k)
    result.rotation[k] += flexibility.softness[k] * clampTo<S>(S(loading.moment[k]), flexibility.knee[k]);
  return result;
}

inline DeflectionSlopes slopesOf(const Flexibility<double>& flexibility, const Loading<double>& loading) {
  DeflectionSlopes slopes;
  slopes.rotation_by_moment = flexibility.compliance;
  if (!flexibility.has_soft_zone) return slopes;
  for (int k = 0; k < 3; ++k)
    if (std::abs(loading.moment[k]) <= flexibility.knee[k]) slopes.rotation_by_moment(k, k) += flexibility.softness[k];
  return slopes;
}

}  // namespace tubeplan::deflection::joint_stiffness
