// Conversion of poses and positions to the plain numbers that kernels read.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>

#include "deflection/revolute_chain/plain_rows.hpp"

namespace tubeplan::deflection::simd {

inline void copy(const Eigen::Vector3d& from, double* to) { std::copy_n(from.data(), 3, to); }

inline PlainPose plainPose(const Eigen::Matrix3d& R, const Eigen::Vector3d& p) {
  PlainPose X;
  copy(p, X.p);
  std::copy_n(R.data(), 9, X.R);
  return X;
}

inline PlainPose plainPose(const Eigen::Isometry3d& X) { return plainPose(X.linear(), X.translation()); }

}  // namespace tubeplan::deflection::simd
