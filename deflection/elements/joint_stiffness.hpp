// Torsional stiffness at a joint or bearing.
//
// Law: theta_k = M_k / K_k about each axis k = x, y, z of the row's frame (Calkins 1994, eq. 2.17, section 2.3.3).
// Symbols: M moment about the row's origin [N m], K stiffness [N m/rad], theta rotation [rad].
// Validity: linear; no knee, clearance or friction. An infinite K is a rigid axis.
#pragma once

#include <cmath>

#include "deflection/elements/element.hpp"

namespace tubeplan::deflection::joint_stiffness {

inline bool isFlexible(const Row<double>& row) { return row.joint_stiffness.array().isFinite().any(); }

inline int segments(const Row<double>&) { return 1; }

template <class S>
Deflection<S> deflect(const Row<S>& row, const Loading<S>& loading) {
  Deflection<S> result;
  for (int k = 0; k < 3; ++k)
    if (std::isfinite(valueOf(row.joint_stiffness[k]))) result.rotation[k] = loading.moment[k] / row.joint_stiffness[k];
  return result;
}

}  // namespace tubeplan::deflection::joint_stiffness
