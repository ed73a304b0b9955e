// Rotations and poses for plain and dual numbers.
#pragma once

#include <cmath>
#include <numbers>

#include "deflection/scalar.hpp"

namespace tubeplan::deflection {

inline constexpr double kFullTurn = 2 * std::numbers::pi;  ///< [rad]

/// Pose of a frame: p_out = R p_in + p.
template <class S>
struct PoseOf {
  Matrix3<S> R = Matrix3<S>::Identity();
  Vector3<S> p = Vector3<S>::Zero();
};

template <class S>
PoseOf<S> operator*(const PoseOf<S>& X_AB, const PoseOf<S>& X_BC) {
  return {X_AB.R * X_BC.R, X_AB.R * X_BC.p + X_AB.p};
}

inline Eigen::Isometry3d toIsometry(const PoseOf<double>& X) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = X.R;
  result.translation() = X.p;
  return result;
}

template <class S>
Matrix3<S> rotationX(const S& angle) {
  using std::cos, std::sin;
  const S c = cos(angle), s = sin(angle), zero(0), one(1);
  Matrix3<S> R;
  R << one, zero, zero, zero, c, S(-s), zero, s, c;
  return R;
}

template <class S>
Matrix3<S> rotationY(const S& angle) {
  using std::cos, std::sin;
  const S c = cos(angle), s = sin(angle), zero(0), one(1);
  Matrix3<S> R;
  R << c, zero, s, zero, one, zero, S(-s), zero, c;
  return R;
}

template <class S>
Matrix3<S> rotationZ(const S& angle) {
  using std::cos, std::sin;
  const S c = cos(angle), s = sin(angle), zero(0), one(1);
  Matrix3<S> R;
  R << c, S(-s), zero, s, c, zero, zero, zero, one;
  return R;
}

/// Returns the matrix of a cross product: a x b = crossMatrix(a) b.
template <class S>
Matrix3<S> crossMatrix(const Vector3<S>& a) {
  const S zero(0);
  Matrix3<S> K;
  K << zero, S(-a.z()), a.y(), a.z(), zero, S(-a.x()), S(-a.y()), a.x(), zero;
  return K;
}

/// Returns the rotation of fixed-axis roll, pitch, yaw [rad]: Rz(yaw) Ry(pitch) Rx(roll), Craig's X-Y-Z fixed angles
/// (gamma, beta, alpha).
template <class S>
Matrix3<S> rotationFromFixedAngles(const Vector3<S>& rpy) {
  return rotationZ<S>(rpy.z()) * rotationY<S>(rpy.y()) * rotationX<S>(rpy.x());
}

/// Returns the fixed angles (gamma, beta, alpha) [rad] of a rotation, with beta in [-pi/2, pi/2]. Near either limit of
/// beta, alpha is arbitrary; gamma is computed for that alpha, so that the three angles always reproduce the rotation.
inline Eigen::Vector3d fixedAnglesOf(const Eigen::Matrix3d& R) {
  const double beta = std::atan2(-R(2, 0), std::hypot(R(0, 0), R(1, 0))), alpha = std::atan2(R(1, 0), R(0, 0));
  const double sine = std::sin(alpha), cosine = std::cos(alpha);
  return {std::atan2(sine * R(0, 2) - cosine * R(1, 2), cosine * R(1, 1) - sine * R(0, 1)), beta, alpha};
}

/// Returns the exponential of a rotation vector [rad]. Below 0.1 rad, a series with an error under 1e-15 keeps the
/// derivatives finite at zero.
template <class S>
Matrix3<S> rotationFromVector(const Vector3<S>& v) {
  using std::cos, std::sin, std::sqrt;
  const S t2 = v.squaredNorm();
  S a, b;
  if (valueOf(t2) < 0.01) {
    a = S(1) - t2 * (1. / 6) * (S(1) - t2 * (1. / 20) * (S(1) - t2 * (1. / 42) * (S(1) - t2 * (1. / 72))));
    b = S(0.5) - t2 * (1. / 24) * (S(1) - t2 * (1. / 30) * (S(1) - t2 * (1. / 56) * (S(1) - t2 * (1. / 90))));
  } else {
    const S t = sqrt(t2);
    a = sin(t) / t;
    b = (S(1) - cos(t)) / t2;
  }
  // I + a [v]x + b ([v]x)^2, written out.
  const Vector3<S> av = v * a, bv = v * b;
  const S xy = bv.x() * v.y(), xz = bv.x() * v.z(), yz = bv.y() * v.z();
  const S xx = bv.x() * v.x(), yy = bv.y() * v.y(), zz = bv.z() * v.z(), one(1);
  Matrix3<S> R;
  R << S(one - yy - zz), S(xy - av.z()), S(xz + av.y()), S(xy + av.z()), S(one - xx - zz), S(yz - av.x()),
      S(xz - av.y()), S(yz + av.x()), S(one - xx - yy);
  return R;
}

/// Returns the left Jacobian J of the exponential map: exp(v + dv) = exp(J dv) exp(v), to first order.
inline Eigen::Matrix3d leftJacobian(const Eigen::Vector3d& v) {
  const double t2 = v.squaredNorm(), t = std::sqrt(t2);
  const bool small = t2 < 0.01;
  const double a = small ? 0.5 - t2 / 24 * (1 - t2 / 30 * (1 - t2 / 56 * (1 - t2 / 90))) : (1 - std::cos(t)) / t2;
  const double b =
      small ? 1. / 6 - t2 / 120 * (1 - t2 / 42 * (1 - t2 / 72 * (1 - t2 / 110))) : (t - std::sin(t)) / (t * t2);
  const Eigen::Matrix3d K = crossMatrix(v);
  return Eigen::Matrix3d::Identity() + a * K + b * K * K;
}

}  // namespace tubeplan::deflection
