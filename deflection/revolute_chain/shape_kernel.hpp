// Deflected shapes of several postures, side by side. See revolute_arm.hpp for the arm and lanes.hpp for the SIMD
// numbers.
//
// Every load is due to gravity. The load on a turn therefore follows from the direction g of gravity in the turn's
// frame, which a sweep outwards computes, and from the magnitude and first moment S of the loads beyond, which a sweep
// inwards gathers. The moment about the turn's axis is S_x g_y - S_y g_x. Both sweeps bend each turn by its current
// moment (symmetric Gauss-Seidel method: each sweep multiplies the error by about the size of a deflection). Within a
// sweep, rotations are updated by their tangents, because computing sines would stall every step. The next sweep starts
// from exact sines.
//
// A beam in the plane of its turn, along v with u = z x v, carries a force F (magnitude `size`, along g), a moment M
// about its far end and a weight W. With rho = chord x g, f = cL size, w = cL W,
//      turn = m + rho (f/2 + w/6),  m = cL M;   chord = (1 - kappa) v + lambda u,
//      lambda = m/2 + rho (f/3 + w/8),  kappa = m^2/6 + rho m (5/24 f + 3/40 w) + rho^2 (f^2/15 + 7/144 f w + w^2/112),
// which is the law of beam.hpp for bending about one axis perpendicular to the member.
#pragma once

#include "deflection/revolute_chain/lanes.hpp"
#include "deflection/revolute_chain/revolute_arm.hpp"

namespace {

using namespace tubeplan::deflection::simd;

struct TurnState {
  Real rest_c, rest_s, c, s;  ///< cosine and sine of the angle without and with deflection
  Vec g;                      ///< direction of gravity, in the turn's frame
  Real sx, sy;                ///< x and y of the first moment of the loads beyond, in axes before the turn's rotation
  Real size;                  ///< sum of the loads beyond [N]
  Real given, moment;         ///< deflection of the turn [rad], moment about its axis [N m]
  Real lambda, kappa, rho;    ///< dimensionless parameters of a beam, as defined above
  Real by_rho, lambda_by_rho, kappa_by_m, kappa_by_rho;
};

/// Active lanes, and the motion of the tip in each lane during a sweep.
struct Progress {
  Bits active;
  Real turned, change;  ///< sum of rotations [rad]; sum of displacement changes of beams [m]
};

inline Vec directionBefore(const TurnState* t, int i, Vec gravity) { return i == 0 ? gravity : t[i - 1].g; }

inline Vec twistIn(const Turn& turn, Vec a) {
  if (turn.twist == kQuarter) return {a.x, -a.z, a.y};
  return {a.x, turn.cos_twist * a.y - turn.sin_twist * a.z, turn.sin_twist * a.y + turn.cos_twist * a.z};
}

inline Vec twistOut(const Turn& turn, Vec a) {
  if (turn.twist == kQuarter) return {a.x, a.z, -a.y};
  return {a.x, turn.cos_twist * a.y + turn.sin_twist * a.z, turn.cos_twist * a.z - turn.sin_twist * a.y};
}

inline void begin(const RevoluteArm& arm, const Postures& in, Real load_at_tip, TurnState* t) {
  Real size = load_at_tip;
  for (int i = arm.count; i-- > 0;) {
    const Turn& turn = arm.turns[i];
    TurnState& state = t[i];
    if (turn.joint >= 0) {
      const SineCosine q = sineCosine(load(in.q + turn.joint * in.stride) + turn.offset);
      state.rest_c = q.cosine;
      state.rest_s = q.sine;
    } else {
      state.rest_c = constant(turn.cos_rest);
      state.rest_s = constant(turn.sin_rest);
    }
    state.c = state.rest_c;
    state.s = state.rest_s;
    state.given = state.moment = state.lambda = state.kappa = state.rho = constant(0);
    state.size = size = size + turn.weight;
    if (!turn.is_beam) continue;
    const Real f = turn.beam_compliance * size;
    const double w = turn.beam_compliance * turn.beam_weight;
    state.by_rho = f * 0.5 + w / 6;
    state.lambda_by_rho = f * (1. / 3) + w / 8;
    state.kappa_by_m = f * (5. / 24) + w * (3. / 40);
    state.kappa_by_rho = (f * f) * (1. / 15) + f * (w * (7. / 144)) + w * w / 112;
    size = size + turn.beam_weight;
  }
}

/// Bends a turn under a moment; returns the change of its deflection [rad]. `before` is the direction of gravity in the
/// frame before the turn.
inline Real bend(const Turn& turn, Real moment, Vec before, TurnState& t, Progress& progress) {
  Real given = turn.compliance * moment;
  if (turn.is_beam) {
    const Real m = turn.beam_compliance * moment;
    const Real across = turn.p[0] * before.y - turn.p[1] * before.x,
               along = turn.p[0] * before.x + turn.p[1] * before.y;
    const Real rho = (across - t.kappa * across) - t.lambda * along;
    const Real lambda = m * 0.5 + rho * t.lambda_by_rho;
    const Real kappa = m * m * (1. / 6) + rho * (m * t.kappa_by_m + rho * t.kappa_by_rho);
    given = given + rho * t.by_rho;
    const double length = __builtin_fabs(turn.p[0]) + __builtin_fabs(turn.p[1]);
    progress.change = progress.change + length * (absolute(lambda - t.lambda) + absolute(kappa - t.kappa));
    t.rho = where(progress.active, rho, t.rho);
    t.lambda = where(progress.active, lambda, t.lambda);
    t.kappa = where(progress.active, kappa, t.kappa);
  }
  t.moment = where(progress.active, moment, t.moment);
  const Real more = where(progress.active, given - t.given, constant(0));
  t.given = t.given + more;
  progress.turned = progress.turned + absolute(more);
  const Bits little = isLess(absolute(more), constant(1e-3));
  Real c = t.c, s = t.s;
  rotateBySmallAngle(more, c, s);
  if (any(~little)) {
    const SineCosine bent = bentSineCosine(t.given);
    c = select(little, c, t.rest_c * bent.cosine - t.rest_s * bent.sine);
    s = select(little, s, t.rest_s * bent.cosine + t.rest_c * bent.sine);
  }
  t.c = c;
  t.s = s;
  return more;
}

/// Return x and y of the deflected vector from the frame before a turn to the turn's frame; z does not change.
inline Real chordX(const Turn& turn, const TurnState& t) {
  return turn.p[0] - t.kappa * turn.p[0] - t.lambda * turn.p[1];
}
inline Real chordY(const Turn& turn, const TurnState& t) {
  return turn.p[1] - t.kappa * turn.p[1] + t.lambda * turn.p[0];
}

inline void turnOutwards(const RevoluteArm& arm, Vec gravity, bool bends, TurnState* t, Progress& progress) {
  Vec g = gravity;
  for (int i = 0; i < arm.count; ++i) {
    const Turn& turn = arm.turns[i];
    TurnState& state = t[i];
    const Vec h = turn.twist ? twistOut(turn, g) : g;
    const Real c = state.c, s = state.s;
    Vec next{c * h.x + s * h.y, c * h.y - s * h.x, h.z};
    if (bends && turn.is_compliant) {
      const Real more = bend(turn, state.sx * h.y - state.sy * h.x, g, state, progress);
      const Real x = next.x;
      next.x = x + more * next.y;
      next.y = next.y - more * x;
    }
    state.g = g = next;
  }
}

inline void gatherInwards(const RevoluteArm& arm, Vec gravity, Real load_at_tip, TurnState* t, Progress& progress) {
  Vec S{load_at_tip * arm.tip_p[0], load_at_tip * arm.tip_p[1], load_at_tip * arm.tip_p[2]};
  for (int i = arm.count; i-- > 0;) {
    const Turn& turn = arm.turns[i];
    TurnState& state = t[i];
    if (turn.has_moment) S = {S.x + turn.moment[0], S.y + turn.moment[1], S.z + turn.moment[2]};
    const Real c = state.c, s = state.s;
    Vec before{c * S.x - s * S.y, s * S.x + c * S.y, S.z};
    if (turn.is_compliant) {
      const Real moment = S.x * state.g.y - S.y * state.g.x;
      const Real more = bend(turn, moment, directionBefore(t, i, gravity), state, progress);
      const Real x = before.x;
      before.x = x - more * before.y;
      before.y = before.y + more * x;
    }
    state.sx = before.x;
    state.sy = before.y;
    S = turn.twist ? twistIn(turn, before) : before;
    if (turn.is_beam) {
      const Real size = state.size + 0.5 * turn.beam_weight;
      S.x = S.x + size * chordX(turn, state);
      S.y = S.y + size * chordY(turn, state);
    } else {
      if (turn.shifted[0]) S.x = S.x + state.size * turn.p[0];
      if (turn.shifted[1]) S.y = S.y + state.size * turn.p[1];
      if (turn.shifted[2]) S.z = S.z + state.size * turn.p[2];
    }
  }
}

/// Sweeps until each lane is at rest. Returns the number of sweeps in each lane, negative if the lane does not
/// converge.
///
/// A lane is at rest if the next sweep would move its tip by less than the tolerance. Either the current sweep moved it
/// by less, or the changes shrink so fast that four times the extrapolated next change is below the tolerance.
inline Real converge(const RevoluteArm& arm, const Postures& in, Vec gravity, Real load_at_tip, TurnState* t) {
  if (!arm.is_compliant) return constant(1);
  Progress progress{isAtMost(constant(0), constant(0)), constant(0), constant(0)};
  turnOutwards(arm, gravity, false, t, progress);
  Real sweeps = constant(0), last = constant(1e300), before = constant(1e300), turned = constant(0);
  Bits failed = progress.active ^ progress.active;
  for (int sweep = 1; sweep <= 2 * in.max_iterations; ++sweep) {
    progress.change = progress.turned = constant(0);
    if (sweep % 2 == 1)
      gatherInwards(arm, gravity, load_at_tip, t, progress);
    else
      turnOutwards(arm, gravity, true, t, progress);
    const Real change = progress.change + (2 * arm.reach) * progress.turned;
    sweeps = where(progress.active, constant(sweep), sweeps);
    const Bits lost = progress.active & ~isLess(change, constant(1e300));
    failed = failed | lost;
    // The bound uses the ratios of the present and of the last sweep, because sweeps inwards and outwards differ.
    const Real next = 4. * change;
    const Bits fast = isLess(change * 10., last) & isLess(last * 10., before) &
                      isAtMost(next * change, in.tolerance * last) & isAtMost(next * last, in.tolerance * before);
    // Bound on the error in this sweep's moments from the tangents used in the sweep before.
    const Bits exact = isAtMost(arm.reach * (turned * turned), constant(in.tolerance));
    progress.active = progress.active & ~(lost | (exact & (isAtMost(change, constant(in.tolerance)) | fast)));
    if (!any(progress.active)) break;
    before = last;
    last = change;
    turned = progress.turned;
  }
  return select(failed | progress.active, constant(-1), sweeps);
}

struct Frame {
  Vec x, y, z, p;
};

inline void turnAbout(Real c, Real s, Frame& X) {
  const Vec x = X.x;
  X.x = c * x + s * X.y;
  X.y = c * X.y - s * x;
}

inline void twistAbout(const Turn& turn, Frame& X) {
  if (turn.twist == kQuarter) {
    const Vec y = X.y;
    X.y = X.z;
    X.z = none() - y;
    return;
  }
  const Real c = constant(turn.cos_twist), s = constant(turn.sin_twist);
  const Vec y = X.y;
  X.y = c * y + s * X.z;
  X.z = c * X.z - s * y;
}

/// Computes the frame of every turn in the base; returns the tip's frame.
inline Frame placeFrames(const RevoluteArm& arm, const TurnState* t, Frame* frames) {
  const Real one = constant(1), zero = constant(0);
  Frame X{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}, none()};
  for (int i = 0; i < arm.count; ++i) {
    const Turn& turn = arm.turns[i];
    if (turn.is_beam) {
      X.p = X.p + (chordX(turn, t[i]) * X.x + chordY(turn, t[i]) * X.y);
    } else {
      if (turn.shifted[0]) X.p = X.p + constant(turn.p[0]) * X.x;
      if (turn.shifted[1]) X.p = X.p + constant(turn.p[1]) * X.y;
      if (turn.shifted[2]) X.p = X.p + constant(turn.p[2]) * X.z;
    }
    if (turn.twist) twistAbout(turn, X);
    turnAbout(t[i].c, t[i].s, X);
    if (frames) frames[i] = X;
  }
  const double* p = arm.tip_p;
  X.p = X.p + (constant(p[0]) * X.x + constant(p[1]) * X.y + constant(p[2]) * X.z);
  if (!arm.tip_turned) return X;
  const auto column = [&](int k) {
    const double* r = arm.tip_R + 3 * k;
    return constant(r[0]) * X.x + constant(r[1]) * X.y + constant(r[2]) * X.z;
  };
  return {column(0), column(1), column(2), X.p};
}

inline void storeVec(double* to, long stride, Vec v) {
  store(to, v.x);
  store(to + stride, v.y);
  store(to + 2 * stride, v.z);
}

inline void storeFrame(double* to, long stride, const Frame& X) {
  storeVec(to, stride, X.p);
  storeVec(to + 3 * stride, stride, X.x);
  storeVec(to + 6 * stride, stride, X.y);
  storeVec(to + 9 * stride, stride, X.z);
}

inline void storeGiven(const RevoluteArm& arm, const TurnState* t, const Shapes& out) {
  for (int i = 0; i < arm.count; ++i) {
    double* to = out.element_states + 4 * i * out.stride;
    store(to, t[i].moment);
    store(to + out.stride, t[i].given);
    store(to + 2 * out.stride, t[i].lambda);
    store(to + 3 * out.stride, t[i].kappa);
  }
}

}  // namespace
