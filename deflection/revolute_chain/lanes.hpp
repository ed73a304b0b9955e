// SIMD numbers with TUBEPLAN_LANES lanes: one double, or a vector register of the processor.
//
// Included by source files that are each compiled for one type of processor. Everything is in an unnamed namespace and
// nothing of the standard library is used, so that the linker cannot substitute code compiled for another processor.
// Every operation is an IEEE operation on doubles, lane by lane (the source files are compiled without contraction).
// The shape of a posture is therefore bit-identical for any number of lanes and any postures in the other lanes.
#pragma once

#if TUBEPLAN_LANES >= 4
#include <immintrin.h>
#endif

namespace {

#if TUBEPLAN_LANES == 1

using Real = double;
using Bits = long long;

inline double lane(Real x, int) { return x; }
inline Real withLane(Real, int, double value) { return value; }
inline bool any(Bits mask) { return mask != 0; }
inline Real select(Bits mask, Real yes, Real no) { return mask ? yes : no; }
/// Returns `yes`: with a single lane, this is only called while the lane is active.
inline Real where(Bits, Real yes, Real) { return yes; }
inline Bits bitsOf(Real x) { return __builtin_bit_cast(Bits, x); }
inline Real realOf(Bits x) { return __builtin_bit_cast(Real, x); }
inline Real absolute(Real x) { return __builtin_fabs(x); }
inline Bits mask(bool x) { return x ? -1 : 0; }
inline Bits isLess(Real a, Real b) { return mask(a < b); }
inline Bits isAtMost(Real a, Real b) { return mask(a <= b); }
inline Bits isZero(Bits x) { return mask(x == 0); }
inline Real load(const double* from) { return *from; }
inline void store(double* to, Real x) { *to = x; }

#else

typedef double Real __attribute__((vector_size(8 * TUBEPLAN_LANES)));
typedef long long Bits __attribute__((vector_size(8 * TUBEPLAN_LANES)));

inline double lane(Real x, int l) { return x[l]; }
inline Real withLane(Real x, int l, double value) {
  x[l] = value;
  return x;
}
inline bool any(Bits mask) {
  long long found = 0;
  for (int l = 0; l < TUBEPLAN_LANES; ++l) found |= mask[l];
  return found != 0;
}
inline Real select(Bits mask, Real yes, Real no) { return mask ? yes : no; }
inline Real where(Bits active, Real yes, Real no) { return active ? yes : no; }
inline Bits bitsOf(Real x) { return __builtin_bit_cast(Bits, x); }
inline Real realOf(Bits x) { return __builtin_bit_cast(Real, x); }
inline Real absolute(Real x) { return realOf(bitsOf(x) & 0x7fffffffffffffffLL); }
inline Bits isLess(Real a, Real b) { return a < b; }
inline Bits isAtMost(Real a, Real b) { return a <= b; }
inline Bits isZero(Bits x) { return x == 0; }
inline Real load(const double* from) {
  Real x;
  __builtin_memcpy(&x, from, sizeof x);
  return x;
}
inline void store(double* to, Real x) { __builtin_memcpy(to, &x, sizeof x); }

#endif

inline Real constant(double x) { return Real{} + x; }
inline Real least(Real a, Real b) { return select(isLess(b, a), b, a); }
inline Real greatest(Real a, Real b) { return select(isLess(a, b), b, a); }

/// Returns the square root, correctly rounded, as IEEE 754 requires of every processor.
inline Real squareRoot(Real x) {
#if TUBEPLAN_LANES == 8
  return (Real)_mm512_maskz_sqrt_pd(0xff, (__m512d)x);  // _mm512_sqrt_pd causes a compiler warning
#elif TUBEPLAN_LANES == 4
  return (Real)_mm256_sqrt_pd((__m256d)x);
#else
  for (int l = 0; l < TUBEPLAN_LANES; ++l) x = withLane(x, l, __builtin_sqrt(lane(x, l)));
  return x;
#endif
}

/// Returns the magnitude of `size` with the sign of `sign`.
inline Real withSign(Real size, Real sign) {
  constexpr long long kSign = static_cast<long long>(1ULL << 63);
  return realOf((bitsOf(size) & ~kSign) | (bitsOf(sign) & kSign));
}

struct SineCosine {
  Real sine, cosine;
};

/// Returns sine and cosine of an angle below 0.1 rad, accurate to rounding.
inline SineCosine smallSineCosine(Real x) {
  const Real t2 = x * x, t4 = t2 * t2;
  // Two independent halves of each series shorten the latency.
  const Real sine = (1. - t2 * (1. / 6)) + t4 * ((1. / 120 - t2 * (1. / 5040)) + t4 * (1. / 362880));
  const Real cosine = (1. - t2 * 0.5) + t4 * ((1. / 24 - t2 * (1. / 720)) + t4 * (1. / 40320));
  return {sine * x, cosine};
}

/// Returns sine and cosine of any angle up to 1e5 rad, within 1.5 units in the last place. The angle is reduced by
/// multiples of a quarter turn in three parts (Cody and Waite), then fdlibm's minimax polynomials apply. For larger
/// angles the reduction loses digits, and the C library is called.
inline SineCosine sineCosine(Real x) {
  constexpr double kShift = 0x1.8p52;
  const Real shifted = x * 6.36619772367581382433e-01 + kShift, k = shifted - kShift;
  const Bits quadrant = bitsOf(shifted);
  const Real a = x - k * 1.57079632673412561417e+00, b = k * 6.07710050630396597660e-11;
  const Real r = a - b;
  const Real r_low = ((a - r) - b) - k * 2.02226624879595063154e-21;  // r + r_low: reduced angle
  const Real y = r, z = y * y;
  const Real ps =
      8.33333333332248946124e-03 +
      z * (-1.98412698298579493134e-04 +
           z * (2.75573137070700676789e-06 + z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)));
  const Real v = z * y;
  const Real sine = y - ((z * (0.5 * r_low - v * ps) - r_low) + v * 1.66666666666666324348e-01);
  const Real pc = z * (4.16666666666666019037e-02 +
                       z * (-1.38888888888741095749e-03 +
                            z * (2.48015872894767294178e-05 +
                                 z * (-2.75573143513906633035e-07 +
                                      z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)))));
  const Real half = 0.5 * z, w = 1. - half;
  const Real cosine = w + (((1. - w) - half) + (z * pc - y * r_low));
  const Bits odd = isZero(quadrant & 1), s_plus = isZero(quadrant & 2), c_plus = isZero((quadrant + 1) & 2);
  Real s = select(odd, sine, cosine), c = select(odd, cosine, sine);
  s = select(s_plus, s, -s);
  c = select(c_plus, c, -c);
  const Bits far = ~isAtMost(absolute(x), constant(1e5));
  if (__builtin_expect(any(far), 0))
    for (int l = 0; l < TUBEPLAN_LANES; ++l) {
      if (__builtin_fabs(lane(x, l)) <= 1e5) continue;
      s = withLane(s, l, __builtin_sin(lane(x, l)));
      c = withLane(c, l, __builtin_cos(lane(x, l)));
    }
  return {s, c};
}

/// Returns sine and cosine of an element's rotation [rad]; fast if it is small in all lanes.
inline SineCosine bentSineCosine(Real x) {
  const SineCosine little = smallSineCosine(x);
  const Bits small = isLess(absolute(x), constant(0.1));
  if (!any(~small)) return little;
  const SineCosine full = sineCosine(x);
  return {select(small, little.sine, full.sine), select(small, little.cosine, full.cosine)};
}

/// Rotates the vector (c, s) by a small angle x [rad]; accurate to rounding below 1e-3 rad.
inline void rotateBySmallAngle(Real x, Real& c, Real& s) {
  const Real t2 = x * x;
  const Real sine = x - x * t2 * (1. / 6), less = t2 * (0.5 - t2 * (1. / 24));
  const Real was = c;
  c = c - (was * less + s * sine);
  s = s + (was * sine - s * less);
}

struct Vec {
  Real x, y, z;
};
inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(Real s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
inline Real dot(Vec a, Vec b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }
inline Vec cross(Vec a, Vec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline Vec none() { return {constant(0), constant(0), constant(0)}; }

}  // namespace
