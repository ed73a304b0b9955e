// Bending and torsion of a uniform cantilever under end force, end moment and distributed weight.
//
// Law: curvature kappa(s) = C M(s), with M(s) the moment at the fraction s in [0, 1] of the member's length,
//        M(s) = M + (1-s) r x F + (1-s)^2/2 r x W,      C = sum_k n_k n_k^T (1/(E I_k) + b_k) + e e^T (1/(G J) + t),
//      rotation     phi   = L C (M + r x F / 2 + r x W / 6),
//      displacement delta = L C (M/2 + r x F / 3 + r x W / 8) x v  +  foreshortening,
//      equal to equations 2.9 to 2.16 of Calkins 1994, with 3 instead of 2 in equation 2.8.
// Symbols: F force [N] and M moment [N m] on the far end, W weight along the member [N], v member [m],
//      L length of v, e = v/L, r deflected chord (so that moments are taken on the bent shape), n_k component of the
//      row's axis k perpendicular to e, scaled to unit length, b_k, t compliances that an effect adds to a member or
//      axis modelled as rigid [1/(N m^2)].
// Foreshortening: the far end of a bent member comes nearer by half the mean square of the slope,
//      1/2 mean(theta(s) x (theta(s) x v)). On the Cobra arm this is 0.003 in, more than the tolerance of the
//      comparison with exact rods.
// Validity: slender, linear elastic, rotation along one element below about 0.1 rad (split it with `segments` beyond).
//      No shear.
#pragma once

#include <cmath>

#include "deflection/elements/element.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::deflection::beam {

inline bool bends(const Beam<double>& b, int axis) { return std::isfinite(b.E) && std::isfinite(b.I[axis]); }
inline bool twists(const Beam<double>& b) { return std::isfinite(b.G) && std::isfinite(b.J); }

inline bool isFlexible(const Row<double>& row) {
  if (row.effect_terms && row.effect_terms->member_is_compliant) return true;
  return row.beam && (bends(*row.beam, 0) || bends(*row.beam, 1) || bends(*row.beam, 2) || twists(*row.beam));
}

inline int segments(const Row<double>& row) { return row.beam ? row.beam->segments : 1; }

/// Returns the component of the row's axis `axis` perpendicular to the member's direction e, scaled to unit length.
template <class S>
Vector3<S> squareTo(const Vector3<S>& e, int axis) {
  Vector3<S> n = Vector3<S>::Unit(axis) - e * e[axis];
  n.normalize();
  return n;
}

/// Returns the curvature per moment [1/(N m^2)] of a member along the unit vector e.
template <class S>
Matrix3<S> curvatureCompliance(const Beam<S>& b, const Vector3<S>& e) {
  Matrix3<S> C = Matrix3<S>::Zero();
  for (int k = 0; k < 3; ++k) {
    if (!std::isfinite(valueOf(b.E)) || !std::isfinite(valueOf(b.I[k]))) continue;
    const Vector3<S> n = squareTo<S>(e, k);
    C += n * n.transpose() / (b.E * b.I[k]);
  }
  if (std::isfinite(valueOf(b.G)) && std::isfinite(valueOf(b.J))) C += e * e.transpose() / (b.G * b.J);
  return C;
}

/// Returns the curvature per moment [1/(N m^2)] added by effects. A member does not bend about an axis along itself.
template <class S>
Matrix3<S> addedCompliance(const EffectTerms<S>& effect_terms, const Vector3<S>& e) {
  Matrix3<S> C = e * e.transpose() * effect_terms.torsion_compliance;
  for (int k = 0; k < 3; ++k) {
    if (!effect_terms.bends[k]) continue;
    const Vector3<S> n = squareTo<S>(e, k);
    C += n * n.transpose() * effect_terms.bending_compliance[k];
  }
  return C;
}

template <class S>
Flexibility<S> flexibilityOf(const Row<S>& row, const Vector3<S>& member) {
  using std::sqrt;
  Flexibility<S> result;
  result.member = member;
  if (valueOf(member.squaredNorm()) == 0) return result;  // a fully retracted bar has no length that could bend
  const S L = sqrt(member.squaredNorm());
  const Vector3<S> e = member / L;
  if (row.beam) result.compliance += curvatureCompliance<S>(*row.beam, e);
  if (row.effect_terms && row.effect_terms->member_is_compliant)
    result.compliance += addedCompliance<S>(*row.effect_terms, e);
  result.compliance *= L;
  return result;
}

/// Slope along the member [rad], theta(s) = m s + f (s - s^2/2) + w (1 - (1-s)^3)/6, with terms due to moment (m),
/// force (f) and distributed weight (w).
template <class S>
struct Slope {
  Vector3<S> m, f, w;
};

/// Computes the deflection under a load. The scalar type `L` of the load is double if only the flexibility has
/// derivatives.
template <class S, class L>
Slope<S> slopeOf(const Flexibility<S>& flexibility, const Loading<L>& loading) {
  return {flexibility.compliance * loading.moment, flexibility.compliance * loading.chord.cross(loading.force),
          flexibility.compliance * loading.chord.cross(loading.weight)};
}

/// Returns half the mean over s of theta(s) times each of its three functions of s. With the returned M, F, W, the mean
/// of theta . theta is 2 (m . M + f . F + w . W).
template <class S>
Slope<S> meansOf(const Slope<S>& t) {
  return {t.m * (1. / 6) + t.f * (5. / 48) + t.w * (3. / 80), t.m * (5. / 48) + t.f * (1. / 15) + t.w * (7. / 288),
          t.m * (3. / 80) + t.f * (7. / 288) + t.w * (1. / 112)};
}

/// Returns half the mean of theta(s) x (theta(s) x v).
template <class S>
Vector3<S> foreshortening(const Slope<S>& t, const Vector3<S>& v) {
  const Slope<S> mean = meansOf<S>(t);
  return mean.m * t.m.dot(v) + mean.f * t.f.dot(v) + mean.w * t.w.dot(v) -
         v * S(t.m.dot(mean.m) + t.f.dot(mean.f) + t.w.dot(mean.w));
}

template <class S, class L>
Deflection<S> deflect(const Flexibility<S>& flexibility, const Loading<L>& loading) {
  const Slope<S> t = slopeOf<S, L>(flexibility, loading);
  Deflection<S> result;
  result.rotation = t.m + t.f * (1. / 2) + t.w * (1. / 6);
  const Vector3<S> lever = t.m * (1. / 2) + t.f * (1. / 3) + t.w * (1. / 8);
  result.displacement = lever.cross(flexibility.member) + foreshortening<S>(t, flexibility.member);
  return result;
}

/// Returns the derivative of the displacement with respect to one term of theta(s); `share` is the term's factor in the
/// `lever` of deflect(), and `mean` its result from meansOf().
inline Eigen::Matrix3d displacementBy(double share, const Eigen::Vector3d& mean, const Eigen::Vector3d& v) {
  return -share * crossMatrix(v) + mean.dot(v) * Eigen::Matrix3d::Identity() + mean * v.transpose() -
         2 * v * mean.transpose();
}

inline DeflectionSlopes slopesOf(const Flexibility<double>& flexibility, const Loading<double>& loading) {
  const Eigen::Matrix3d& C = flexibility.compliance;
  const Eigen::Vector3d& v = flexibility.member;
  const Slope<double> mean = meansOf<double>(slopeOf<double, double>(flexibility, loading));
  const Eigen::Matrix3d by_arm = C * crossMatrix(loading.chord), by_force = -C * crossMatrix(loading.force),
                        by_weight = -C * crossMatrix(loading.weight);
  const Eigen::Matrix3d m = displacementBy(1. / 2, mean.m, v), f = displacementBy(1. / 3, mean.f, v),
                        w = displacementBy(1. / 8, mean.w, v);
  return {f * by_arm, m * C, w * by_arm, f * by_force + w * by_weight,
          by_arm / 2, C,     by_arm / 6, by_force / 2 + by_weight / 6};
}

}  // namespace tubeplan::deflection::beam
