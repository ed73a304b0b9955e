// A uniform cantilever under end force, end moment and distributed weight, with torsion.
//
// Law: curvature kappa(s) = C M(s), M(s) the moment at s in [0, 1] of the member,
//        M(s) = M + (1-s) r x F + (1-s)^2/2 r x W,      C = sum_k n_k n_k^T (1/(E I_k) + b_k) + e e^T (1/(G J) + t),
//      rotation     phi   = L C (M + r x F / 2 + r x W / 6),
//      displacement delta = L C (M/2 + r x F / 3 + r x W / 8) x v  +  foreshortening,
//      which are equations 2.9 to 2.16 of Calkins 1994 with 3 for 2 in equation 2.8.
// Symbols: F, M force [N] and moment [N m] on the far end, W weight along the member [N], v the member [m], L its
// length, e = v/L,
//      r the deflected chord (so that moments are taken on the bent shape), n_k the row's axis k made square to e,
//      b_k, t compliances that an addition gives a member or axis taken as rigid [1/(N m^2)].
// Foreshortening: a bent member ends nearer, by half the mean square of its slope, 1/2 mean(theta(s) x (theta(s) x v));
// 0.003 in on
//      the Cobra arm, which is more than the tolerance against exact rods.
// Validity: slender, linear elastic, rotation along one element below about 0.1 rad (split it with `segments` beyond).
// No shear.
#pragma once

#include <cmath>

#include "deflection/elements/element.hpp"

namespace tubeplan::deflection::beam {

inline bool bends(const Beam<double>& b, int axis) { return std::isfinite(b.E) && std::isfinite(b.I[axis]); }
inline bool twists(const Beam<double>& b) { return std::isfinite(b.G) && std::isfinite(b.J); }

inline bool isFlexible(const Row<double>& row) {
  if (row.addition && row.addition->member_gives) return true;
  return row.beam && (bends(*row.beam, 0) || bends(*row.beam, 1) || bends(*row.beam, 2) || twists(*row.beam));
}

inline int segments(const Row<double>& row) { return row.beam ? row.beam->segments : 1; }

/// The row's axis made square to the member, unit length.
template <class S>
Vector3<S> squareTo(const Vector3<S>& e, int axis) {
  Vector3<S> n = Vector3<S>::Unit(axis) - e * e[axis];
  n.normalize();
  return n;
}

/// Curvature per moment [1/(N m^2)], for a member along the unit vector e.
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

/// The same of an addition. An axis along the member has no bending about it.
template <class S>
Matrix3<S> addedCompliance(const Addition<S>& addition, const Vector3<S>& e) {
  Matrix3<S> C = e * e.transpose() * addition.torsion_compliance;
  for (int k = 0; k < 3; ++k) {
    if (!addition.bends[k]) continue;
    const Vector3<S> n = squareTo<S>(e, k);
    C += n * n.transpose() * addition.bending_compliance[k];
  }
  return C;
}

/// 1/2 of the integral of theta(s) x (theta(s) x v), theta(s) = m s + f (s - s^2/2) + w (1 - (1-s)^3)/6.
template <class S>
Vector3<S> foreshortening(const Vector3<S>& m, const Vector3<S>& f, const Vector3<S>& w, const Vector3<S>& v) {
  const Vector3<S> mv = m.cross(v), fv = f.cross(v), wv = w.cross(v);
  const Vector3<S> mm = m.cross(mv), ff = f.cross(fv), ww = w.cross(wv);
  const Vector3<S> mf = m.cross(fv) + f.cross(mv), mw = m.cross(wv) + w.cross(mv), fw = f.cross(wv) + w.cross(fv);
  const Vector3<S> sum =
      (mm + mm) / 6. + (ff + ff) / 15. + (ww + ww) / 112. + mf * (5. / 24) + mw * (3. / 40) + fw * (7. / 144);
  return sum / 2.;
}

template <class S>
Deflection<S> deflect(const Row<S>& row, const Loading<S>& loading) {
  using std::sqrt;
  const Vector3<S>& v = loading.member;
  Deflection<S> result;
  if (valueOf(v.squaredNorm()) == 0) return result;  // a slide drawn fully in has nothing to bend
  const S L = sqrt(v.squaredNorm());
  const Vector3<S> e = v / L;
  Matrix3<S> C = Matrix3<S>::Zero();
  if (row.beam) C += curvatureCompliance<S>(*row.beam, e);
  if (row.addition && row.addition->member_gives) C += addedCompliance<S>(*row.addition, e);
  C *= L;
  const Vector3<S> m = C * loading.moment;
  const Vector3<S> f = C * loading.chord.cross(loading.force);
  const Vector3<S> w = C * loading.chord.cross(loading.weight);
  result.rotation = m + f / 2. + w / 6.;
  const Vector3<S> lever = m / 2. + f / 3. + w / 8.;
  result.displacement = lever.cross(v) + foreshortening<S>(m, f, w, v);
  return result;
}

}  // namespace tubeplan::deflection::beam
