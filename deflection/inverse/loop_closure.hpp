// The closure of a serial chain as equations that are linear in every joint (Raghavan and Roth 1993, "Inverse
// kinematics of the general 6R manipulator and related linkages", J. Mech. Des. 115).
//
// A rigid motion moves a point p and an axis l. Fifteen quantities of p and l change linearly under every motion: l, p,
// p x l, (p.p) l - 2 (p.l) p, p.p, p.l and 1. The motion of a joint is a matrix of three terms, with factors 1, cos q
// and sin q, or 1, d and d^2 for a prismatic joint. The five quantities p, p.p and 1 form a system of their own.
// Internal to the inverse kinematics.
#pragma once

#include <Eigen/Core>
#include <array>

#include "deflection/rigid_tip.hpp"

namespace tubeplan::deflection {

inline constexpr int kLineSize = 15;  ///< number of quantities: l, p, p x l, (p.p) l - 2 (p.l) p, p.p, p.l, 1
inline constexpr int kPlaceSize = 5;  ///< number of quantities: p, p.p, 1

template <int Size>
using Closure = Eigen::Matrix<double, Size, 1>;

Closure<kLineSize> lineClosure(const Eigen::Vector3d& p, const Eigen::Vector3d& l);
Closure<kPlaceSize> placeClosure(const Eigen::Vector3d& p);

/// The matrices of the three terms of a joint's motion; the last row of each belongs to the quantity 1.
template <int Size>
using JointTerms = std::array<Eigen::Matrix<double, Size, Size>, 3>;

/// A joint's motion in terms of 1, cos q and sin q (1, d and d^2 for a prismatic joint).
template <int Size>
struct JointClosure {
  JointTerms<Size> forward, backward;  ///< terms of the motion by q and of its inverse, the motion by -q
  bool slides;
};

/// Returns the motion of the k-th joint.
template <int Size>
JointClosure<Size> jointClosure(const AxesAtZero& axes, std::size_t k);

/// Returns the coefficients of 1, x and x^2 in the motion multiplied by 1 + x^2, where x = tan((q - zero) / 2). For a
/// prismatic joint, d = zero + x and the motion is not multiplied.
template <int Size>
JointTerms<Size> byHalfTangent(const JointClosure<Size>& joint, double zero);

/// Returns the coefficients of 1, x and x^2 in 1 + x^2, or in the constant 1 for a prismatic joint.
inline Eigen::Vector3d weightOf(bool slides) { return {1, 0, slides ? 0. : 1.}; }

}  // namespace tubeplan::deflection
