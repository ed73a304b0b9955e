// Exact derivatives of the deflected tip by the joints, of shapes side by side.
//
// In the base, with axis z_i, place p_i and first moment S_i (of the loads beyond, about p_i) of each turn: a turn of j
// changes the moment about any axis i nearer to the base, or the same, by z_i . a_j, a_j = (z_j x S_j) x g, and about
// any farther one by z_j . a_i: dead loads have a potential. With a beam's lambda and kappa as its other unknowns that
// makes a small linear system for what gives when a joint turns; its diagonal is one and the rest a deflection's
// share, so that it is eliminated without pivoting.
#pragma once

#include "deflection/hinges/shape_kernel.hpp"

namespace {

struct Unknown {
  int turn;
  bool is_rho;  ///< of a beam's force, else what the turn gives
  Vec shifts;   ///< displacement of all beyond, per unit (beams)
  Vec a;        ///< change of the moments nearer to the base by the shift and the turn
  Vec turns;    ///< of a beam's rho: its change by turns nearer to the base
};

struct Linearization {
  Unknown unknown[kMaxUnknowns];
  int count;
  Vec a[kMaxTurns];
  Real rows[kMaxUnknowns][kMaxUnknowns + kMaxJoints];
};

/// First moment beyond each turn about its place, into `S`.
inline void momentsBeyond(const HingeArm& arm, const TurnState* t, const Frame* frames, const Frame& tip, Real at_tip,
                          Vec* S) {
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

/// (z x S) x g.
inline Vec momentByTurn(Vec z, Vec S, Vec g) { return dot(z, g) * S - dot(S, g) * z; }

/// How a beam's lambda and kappa change with what its turn gives and with rho.
struct BeamSlopes {
  Real lambda_by_given, kappa_by_given, lambda_by_rho, kappa_by_rho;
};

inline BeamSlopes slopesOf(const Turn& turn, const TurnState& t) {
  const Real m = turn.beam_compliance * t.moment;
  const double share = turn.beam_compliance / turn.compliance;  // of m in what the turn gives
  const Real by_m = m * (1. / 3) + t.rho * t.kappa_by_m, by_rho = m * t.kappa_by_m + 2. * (t.rho * t.kappa_by_rho);
  const Real m_by_rho = -share * t.by_rho;
  return {constant(0.5 * share), share * by_m, t.lambda_by_rho + 0.5 * m_by_rho, by_rho + m_by_rho * by_m};
}

inline void addUnknowns(const HingeArm& arm, const TurnState* t, const Frame* frames, Vec g, Linearization& lin) {
  lin.count = 0;
  for (int i = 0; i < arm.count; ++i) {
    const Turn& turn = arm.turns[i];
    if (!turn.gives) continue;
    Unknown& given = lin.unknown[lin.count++];
    given = {i, false, none(), lin.a[i], none()};
    if (!turn.is_beam) continue;
    const Frame& near = frames[i - 1];
    const Vec along = constant(turn.p[0]) * near.x + constant(turn.p[1]) * near.y,
              across = constant(turn.p[0]) * near.y - constant(turn.p[1]) * near.x;
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

/// Change of the moment about turn i's axis by what turns turn j.
inline Real momentBy(const Frame* frames, const Vec* a, int i, int j) {
  return i <= j ? dot(frames[i].z, a[j]) : dot(frames[j].z, a[i]);
}

/// The equation of what a turn gives, per unit of unknown `u`.
inline Real momentBy(const Frame* frames, const Linearization& lin, int i, const Unknown& u) {
  if (i < u.turn) return dot(frames[i].z, u.a);
  return u.is_rho ? constant(0) : momentBy(frames, lin.a, i, u.turn);
}

inline void addEquations(const HingeArm& arm, const TurnState* t, const Frame* frames, Vec g, Linearization& lin) {
  for (int r = 0; r < lin.count; ++r) {
    const Unknown& own = lin.unknown[r];
    const Turn& turn = arm.turns[own.turn];
    Real* row = lin.rows[r];
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

inline void eliminate(int columns, Linearization& lin) {
  const int n = lin.count;
  for (int k = 0; k < n; ++k) {
    const Real inverse = 1. / lin.rows[k][k];
    for (int c = k + 1; c < columns; ++c) lin.rows[k][c] = lin.rows[k][c] * inverse;
    for (int r = k + 1; r < n; ++r) {
      const Real factor = lin.rows[r][k];
      for (int c = k + 1; c < columns; ++c) lin.rows[r][c] = lin.rows[r][c] - factor * lin.rows[k][c];
    }
  }
  for (int k = n; k-- > 0;)
    for (int r = 0; r < k; ++r) {
      const Real factor = lin.rows[r][k];
      for (int c = n; c < columns; ++c) lin.rows[r][c] = lin.rows[r][c] - factor * lin.rows[k][c];
    }
}

struct Motion {
  Vec p, w;
};

/// Motion of the tip by each joint.
inline void deriveByJoints(const HingeArm& arm, const TurnState* t, const Frame* frames, const Frame& tip, Vec gravity,
                           Real at_tip, Motion* columns) {
  Linearization lin;
  Vec S[kMaxTurns];
  momentsBeyond(arm, t, frames, tip, at_tip, S);
  for (int i = 0; i < arm.count; ++i) lin.a[i] = momentByTurn(frames[i].z, S[i], gravity);
  addUnknowns(arm, t, frames, gravity, lin);
  addEquations(arm, t, frames, gravity, lin);
  eliminate(lin.count + arm.joints, lin);
  for (int i = 0; i < arm.count; ++i)
    if (arm.turns[i].joint >= 0) columns[arm.turns[i].joint] = {cross(frames[i].z, tip.p - frames[i].p), frames[i].z};
  for (int k = 0; k < lin.count; ++k) {
    const Unknown& u = lin.unknown[k];
    const Vec z = frames[u.turn].z;
    const Vec p = u.is_rho ? u.shifts : u.shifts + cross(z, tip.p - frames[u.turn].p);
    for (int j = 0; j < arm.joints; ++j) {
      const Real by = lin.rows[k][lin.count + j];
      columns[j].p = columns[j].p + by * p;
      if (!u.is_rho) columns[j].w = columns[j].w + by * z;
    }
  }
}

inline void storeJacobian(const HingeArm& arm, const Motion* columns, const Shapes& out) {
  for (int j = 0; j < arm.joints; ++j) {
    double* to = out.jacobian + 6 * j * out.stride;
    storeVec(to, out.stride, columns[j].p);
    storeVec(to + 3 * out.stride, out.stride, columns[j].w);
  }
}

inline void solveShapes(const HingeArm& arm, const Postures& in, const Shapes& out) {
  TurnState t[kMaxTurns];
  Frame frames[kMaxTurns];
  const Vec gravity{load(in.gravity), load(in.gravity + in.stride), load(in.gravity + 2 * in.stride)};
  const Real at_tip = load(in.load);
  begin(arm, in, at_tip, t);
  const Real sweeps = settle(arm, in, gravity, at_tip, t);
  const Frame tip = placeFrames(arm, t, out.jacobian || out.turns ? frames : nullptr);
  const Bits finite = isLess(absolute(tip.p.x) + absolute(tip.p.y) + absolute(tip.p.z), constant(1e300));
  store(out.sweeps, select(finite, sweeps, constant(-1)));
  storeFrame(out.pose, out.stride, tip);
  if (out.gives) storeGiven(arm, t, out);
  if (out.turns)
    for (int i = 0; i < arm.count; ++i) storeFrame(out.turns + 12 * i * out.stride, out.stride, frames[i]);
  if (!out.jacobian) return;
  Motion columns[kMaxJoints];
  deriveByJoints(arm, t, frames, tip, gravity, at_tip, columns);
  storeJacobian(arm, columns, out);
}

}  // namespace
