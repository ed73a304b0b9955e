// Exact derivatives of the deflected tip by the joints, by gravity's direction and by compliances, of shapes side by
// side.
//
// In the base, with axis z_i, place p_i and first moment S_i (of the loads beyond, about p_i) of each turn: a turn of j
// changes the moment about any axis i nearer to the base, or its own, by z_i . a_j, a_j = (z_j x S_j) x g, and about
// any farther one by z_j . a_i: dead loads have a potential. With a beam's lambda and kappa as its other unknowns that
// makes a small linear system for the deflections when a joint turns; its diagonal is one and the rest a deflection's
// share, so that it is eliminated without pivoting. Gravity and compliances are further columns of the same system.
#pragma once

#include "deflection/revolute_chain/shape_kernel.hpp"

namespace {

struct Unknown {
  int turn;
  bool is_rho;  ///< true: a beam's rho; false: the deflection of the turn
  Vec shifts;   ///< displacement of everything beyond, per unit (beams)
  Vec a;        ///< change of the moments nearer to the base by the shift and the rotation
  Vec turns;    ///< change of a beam's rho by turns nearer to the base
};

/// Changes by a compliance of a turn, of its springs or its beam, under the same moment.
struct Softening {
  Real given;  ///< change of the turn's deflection
  Vec shift;   ///< displacement of everything beyond, without that by `given` (beams)
  Vec a;       ///< change of the moments nearer to the base by the shift
};

inline constexpr int kMaxColumns = kMaxJoints + kGravityTurns + kMaxUnknowns;

struct Linearization {
  Unknown unknown[kMaxUnknowns];
  Softening softening[kMaxUnknowns];  ///< softening of the springs for a deflection, of the beam for its rho
  int count;
  Vec S[kMaxTurns], a[kMaxTurns];
  int width;  ///< length of a row: the unknowns, then the variables of derivatives
  Real equations[kMaxUnknowns * (kMaxUnknowns + kMaxColumns)];
  Real* row(int r) { return equations + r * width; }
};

/// Derivatives wanted besides those by joints.
struct Asked {
  bool gravity, compliances;
};

/// Computes the first moment beyond each turn about its place, into `S`.
inline void outboardMoments(const RevoluteArm& arm, const TurnState* t, const Frame* frames, const Frame& tip,
                            Real at_tip, Vec* S) {
  Vec moment = at_tip * (tip.p - frames[arm.count - 1].p);
  for (int i = arm.count; i-- > 0;) {
    const Turn& turn = arm.turns[i];
    const Frame& X = frames[i];
    if (turn.has_moment)
      moment =
          moment + (constant(turn.moment[0]) * X.x + constant(turn.moment[1]) * X.y + constant(turn.moment[2]) * X.z);
    S[i] = moment;
    if (i > 0) moment = moment + (t[i].size + 0.5 * turn.beam_weight) * (X.p - frames[i - 1].p);
  }
}

/// Returns (z x S) x g.
inline Vec momentByTurn(Vec z, Vec S, Vec g) { return dot(z, g) * S - dot(S, g) * z; }

/// Slopes of a beam's lambda and kappa by its turn's deflection and by rho.
struct BeamSlopes {
  Real lambda_by_given, kappa_by_given, lambda_by_rho, kappa_by_rho;
};

inline BeamSlopes slopesOf(const Turn& turn, const TurnState& t) {
  const Real m = turn.beam_compliance * t.moment;
  const double share = turn.beam_compliance / turn.compliance;  // share of m in the turn's deflection
  const Real by_m = m * (1. / 3) + t.rho * t.kappa_by_m, by_rho = m * t.kappa_by_m + 2. * (t.rho * t.kappa_by_rho);
  const Real m_by_rho = -share * t.by_rho;
  return {constant(0.5 * share), share * by_m, t.lambda_by_rho + 0.5 * m_by_rho, by_rho + m_by_rho * by_m};
}

/// Return the vectors along a beam and across it, in the base.
inline Vec alongBeam(const Turn& turn, const Frame& near) {
  return constant(turn.p[0]) * near.x + constant(turn.p[1]) * near.y;
}
inline Vec acrossBeam(const Turn& turn, const Frame& near) {
  return constant(turn.p[0]) * near.y - constant(turn.p[1]) * near.x;
}

inline void addUnknowns(const RevoluteArm& arm, const TurnState* t, const Frame* frames, Vec g, Linearization& lin) {
  lin.count = 0;
  for (int i = 0; i < arm.count; ++i) {
    const Turn& turn = arm.turns[i];
    if (!turn.is_compliant) continue;
    Unknown& given = lin.unknown[lin.count++];
    given = {i, false, none(), lin.a[i], none()};
    if (!turn.is_beam) continue;
    const Frame& near = frames[i - 1];
    const Vec along = alongBeam(turn, near), across = acrossBeam(turn, near);
    const BeamSlopes slopes = slopesOf(turn, t[i]);
    const Real size = t[i].size + 0.5 * turn.beam_weight;
    given.shifts = slopes.lambda_by_given * across - slopes.kappa_by_given * along;
    given.a = given.a + size * cross(given.shifts, g);
    Unknown& rho = lin.unknown[lin.count++];
    rho = {i, true, slopes.lambda_by_rho * across - slopes.kappa_by_rho * along, none(), none()};
    rho.a = size * cross(rho.shifts, g);
    rho.turns = momentByTurn(near.z, frames[i].p - near.p, g);
  }
}

/// Returns the change of the moment about turn i's axis by a rotation of turn j.
inline Real momentBy(const Frame* frames, const Vec* a, int i, int j) {
  return i <= j ? dot(frames[i].z, a[j]) : dot(frames[j].z, a[i]);
}

/// Returns the change of the moment on a turn per unit of unknown `u`.
inline Real momentBy(const Frame* frames, const Linearization& lin, int i, const Unknown& u) {
  if (i < u.turn) return dot(frames[i].z, u.a);
  return u.is_rho ? constant(0) : momentBy(frames, lin.a, i, u.turn);
}

inline void addEquations(const RevoluteArm& arm, const TurnState* t, const Frame* frames, Vec g, Linearization& lin) {
  for (int r = 0; r < lin.count; ++r) {
    const Unknown& own = lin.unknown[r];
    const Turn& turn = arm.turns[own.turn];
    Real* row = lin.row(r);
    const Real minus = constant(-turn.compliance);
    for (int k = 0; k < lin.count; ++k) {
      const Unknown& u = lin.unknown[k];
      if (!own.is_rho)
        row[k] = minus * momentBy(frames, lin, own.turn, u);
      else
        row[k] = u.turn < own.turn && !u.is_rho ? -dot(frames[u.turn].z, own.turns) : constant(0);
    }
    for (int i = 0; i < arm.count; ++i) {
      const int j = arm.turns[i].joint;
      if (j < 0) continue;
      row[lin.count + j] = own.is_rho ? (i < own.turn ? dot(frames[i].z, own.turns) : constant(0))
                                      : turn.compliance * momentBy(frames, lin.a, own.turn, i);
    }
    row[r] = row[r] + 1.;
    if (own.is_rho) {
      // rho = n . (chord x g): the chord's own change.
      const Vec n = frames[own.turn - 1].z;
      row[r - 1] = row[r - 1] - dot(n, cross(lin.unknown[r - 1].shifts, g));
      row[r] = row[r] - dot(n, cross(own.shifts, g));
    } else if (turn.is_beam) {
      row[r + 1] = row[r + 1] - t[own.turn].by_rho;
    }
  }
}

inline void eliminate(Linearization& lin) {
  const int n = lin.count, columns = lin.width;
  for (int k = 0; k < n; ++k) {
    Real* pivot = lin.row(k);
    const Real inverse = 1. / pivot[k];
    for (int c = k + 1; c < columns; ++c) pivot[c] = pivot[c] * inverse;
    for (int r = k + 1; r < n; ++r) {
      Real* row = lin.row(r);
      const Real factor = row[k];
      for (int c = k + 1; c < columns; ++c) row[c] = row[c] - factor * pivot[c];
    }
  }
  for (int k = n; k-- > 0;) {
    const Real* pivot = lin.row(k);
    for (int r = 0; r < k; ++r) {
      Real* row = lin.row(r);
      const Real factor = row[k];
      for (int c = n; c < columns; ++c) row[c] = row[c] - factor * pivot[c];
    }
  }
}

/// Adds columns for gravity rotated about each axis of the base, from column `first`.
inline void addGravity(const RevoluteArm& arm, const Frame* frames, Vec g, int first, Linearization& lin) {
  const Real zero = constant(0);
  const Vec turned[kGravityTurns] = {{zero, -g.z, g.y}, {g.z, zero, -g.x}, {-g.y, g.x, zero}};
  for (int r = 0; r < lin.count; ++r) {
    const Unknown& own = lin.unknown[r];
    const Frame& X = frames[own.turn];
    // The moment is z . (S x g), rho is n . (chord x g).
    const Vec by = own.is_rho ? cross(frames[own.turn - 1].z, X.p - frames[own.turn - 1].p)
                              : constant(arm.turns[own.turn].compliance) * cross(X.z, lin.S[own.turn]);
    for (int axis = 0; axis < kGravityTurns; ++axis) lin.row(r)[first + axis] = dot(by, turned[axis]);
  }
}

inline void findSoftenings(const RevoluteArm& arm, const TurnState* t, const Frame* frames, Vec g, Linearization& lin) {
  for (int k = 0; k < lin.count; ++k) {
    const Unknown& own = lin.unknown[k];
    const Turn& turn = arm.turns[own.turn];
    const TurnState& state = t[own.turn];
    Softening& by = lin.softening[k];
    by = {state.moment, none(), none()};
    if (!turn.is_beam) continue;
    if (own.is_rho) {
      // The response of a beam is proportional to its compliance, except for kappa, which depends on the square.
      const double inverse = 1 / turn.beam_compliance;
      by.given = state.moment + inverse * (state.rho * state.by_rho);
      by.shift = inverse * state.lambda * acrossBeam(turn, frames[own.turn - 1]) -
                 2 * inverse * state.kappa * alongBeam(turn, frames[own.turn - 1]);
    }
    // The displacement by the angle alone is counted with the angle.
    by.shift = by.shift - by.given * lin.unknown[own.is_rho ? k - 1 : k].shifts;
    by.a = (state.size + 0.5 * turn.beam_weight) * cross(by.shift, g);
  }
}

/// Adds columns for the compliances, from column `first`.
inline void addSoftenings(const RevoluteArm& arm, const Frame* frames, Vec g, int first, Linearization& lin) {
  for (int k = 0; k < lin.count; ++k) {
    const int i = lin.unknown[k].turn;
    const Softening& by = lin.softening[k];
    for (int r = 0; r < lin.count; ++r) {
      const Unknown& own = lin.unknown[r];
      Real& entry = lin.row(r)[first + k];
      entry = constant(0);
      if (own.is_rho) {
        if (own.turn == i) entry = dot(frames[i - 1].z, cross(by.shift, g));
      } else if (own.turn == i) {
        entry = by.given;
      } else if (own.turn < i && arm.turns[i].is_beam) {
        entry = arm.turns[own.turn].compliance * dot(frames[own.turn].z, by.a);
      }
    }
  }
}

struct Motion {
  Vec p, w;
};

/// Computes the motion of the tip by each joint, then by the other variables asked for: gravity's rotations, then the
/// compliance of each unknown (a turn's springs, a beam for its rho).
inline void derive(const RevoluteArm& arm, const TurnState* t, const Frame* frames, const Frame& tip, Vec gravity,
                   Real at_tip, Asked asked, Linearization& lin, Motion* columns) {
  outboardMoments(arm, t, frames, tip, at_tip, lin.S);
  for (int i = 0; i < arm.count; ++i) lin.a[i] = momentByTurn(frames[i].z, lin.S[i], gravity);
  addUnknowns(arm, t, frames, gravity, lin);
  lin.width = lin.count + arm.joints + (asked.gravity ? kGravityTurns : 0) + (asked.compliances ? lin.count : 0);
  addEquations(arm, t, frames, gravity, lin);
  for (int i = 0; i < arm.count; ++i)
    if (arm.turns[i].joint >= 0) columns[arm.turns[i].joint] = {cross(frames[i].z, tip.p - frames[i].p), frames[i].z};
  int count = arm.joints;
  if (asked.gravity) {
    addGravity(arm, frames, gravity, lin.count + count, lin);
    for (int axis = 0; axis < kGravityTurns; ++axis) columns[count++] = {none(), none()};
  }
  if (asked.compliances) {
    findSoftenings(arm, t, frames, gravity, lin);
    addSoftenings(arm, frames, gravity, lin.count + count, lin);
    for (int k = 0; k < lin.count; ++k) columns[count++] = {lin.softening[k].shift, none()};
  }
  eliminate(lin);
  for (int k = 0; k < lin.count; ++k) {
    const Unknown& u = lin.unknown[k];
    const Vec z = frames[u.turn].z;
    const Vec p = u.is_rho ? u.shifts : u.shifts + cross(z, tip.p - frames[u.turn].p);
    for (int j = 0; j < count; ++j) {
      const Real by = lin.row(k)[lin.count + j];
      columns[j].p = columns[j].p + by * p;
      if (!u.is_rho) columns[j].w = columns[j].w + by * z;
    }
  }
}

/// Computes the motion of the tip by each joint.
inline void deriveByJoints(const RevoluteArm& arm, const TurnState* t, const Frame* frames, const Frame& tip,
                           Vec gravity, Real at_tip, Motion* columns) {
  Linearization lin;
  derive(arm, t, frames, tip, gravity, at_tip, {false, false}, lin, columns);
}

inline void storeMotion(const Motion& motion, double* to, long stride) {
  storeVec(to, stride, motion.p);
  storeVec(to + 3 * stride, stride, motion.w);
}

inline void storeJacobian(const RevoluteArm& arm, const Linearization& lin, const Motion* columns, const Shapes& out) {
  const long size = 6 * out.derivative_stride;
  for (int j = 0; j < arm.joints; ++j) storeMotion(*columns++, out.jacobian + j * size, out.derivative_stride);
  if (out.by_gravity)
    for (int axis = 0; axis < kGravityTurns; ++axis)
      storeMotion(*columns++, out.by_gravity + axis * size, out.derivative_stride);
  if (out.by_compliance)
    for (int k = 0; k < lin.count; ++k)
      storeMotion(*columns++, out.by_compliance + (2 * lin.unknown[k].turn + lin.unknown[k].is_rho) * size,
                  out.derivative_stride);
}

inline void solveShapes(const RevoluteArm& arm, const Postures& in, const Shapes& out) {
  TurnState t[kMaxTurns];
  Frame frames[kMaxTurns];
  const Vec gravity{load(in.gravity), load(in.gravity + in.stride), load(in.gravity + 2 * in.stride)};
  const Real at_tip = load(in.load);
  begin(arm, in, at_tip, t);
  const Real sweeps = converge(arm, in, gravity, at_tip, t);
  const Frame tip = placeFrames(arm, t, out.jacobian || out.turns ? frames : nullptr);
  const Bits finite = isLess(absolute(tip.p.x) + absolute(tip.p.y) + absolute(tip.p.z), constant(1e300));
  store(out.sweeps, select(finite, sweeps, constant(-1)));
  storeFrame(out.pose, out.stride, tip);
  if (out.element_states) storeGiven(arm, t, out);
  if (out.turns)
    for (int i = 0; i < arm.count; ++i) storeFrame(out.turns + 12 * i * out.stride, out.stride, frames[i]);
  if (!out.jacobian) return;
  Motion columns[kMaxColumns];
  Linearization lin;
  derive(arm, t, frames, tip, gravity, at_tip, {out.by_gravity != nullptr, out.by_compliance != nullptr}, lin, columns);
  storeJacobian(arm, lin, columns, out);
}

}  // namespace
