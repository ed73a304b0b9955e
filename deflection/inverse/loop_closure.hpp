// The closure of a serial chain as equations that are linear in every joint (Raghavan and Roth 1993, "Inverse
// kinematics of the general 6R manipulator and related linkages", J. Mech. Des. 115).
//
// A place p and an axis l that a rigid motion moves have fifteen quantities which every motion changes linearly: l, p,
// p x l, (p.p) l - 2 (p.l) p, p.p, p.l and 1. A joint's motion of them is a matrix of three terms, of 1, cos q and sin
// q, or of 1, d and d^2 for a slide. p, p.p and 1 alone are five that form a system of their own. Internal to the
// inverse.
#pragma once

#include <Eigen/Core>
#include <array>

#include "deflection/rigid_tip.hpp"

namespace tubeplan::deflection {

inline constexpr int kLineSize = 15;  ///< l, p, p x l, (p.p) l - 2 (p.l) p, p.p, p.l, 1
inline constexpr int kPlaceSize = 5;  ///< p, p.p, 1

template <int Size>
using Closure = Eigen::Matrix<double, Size, 1>;

Closure<kLineSize> lineClosure(const Eigen::Vector3d& p, const Eigen::Vector3d& l);
Closure<kPlaceSize> placeClosure(const Eigen::Vector3d& p);

/// The three terms of a joint's motion; the last row of each is that of the quantity 1.
template <int Size>
using JointTerms = std::array<Eigen::Matrix<double, Size, Size>, 3>;

/// A joint's motion by 1, cos q, sin q (1, d, d^2 for a slide).
template <int Size>
struct JointClosure {
  JointTerms<Size> forth, back;  ///< motions by q and by -q
  bool slides;
};

/// Returns the motion of the k-th joint.
template <int Size>
JointClosure<Size> jointClosure(const AxesAtZero& axes, std::size_t k);

/// Returns the terms by 1, x, x^2, multiplied by 1 + x^2, where x = tan((q - zero) / 2); for a slide d = zero + x.
template <int Size>
JointTerms<Size> byHalfTangent(const JointClosure<Size>& joint, double zero);

/// Returns the coefficients by 1, x, x^2 of 1 + x^2, or of 1 for a slide.
inline Eigen::Vector3d weightOf(bool slides) { return {1, 0, slides ? 0. : 1.}; }

}  // namespace tubeplan::deflection
