// Exact derivatives of the deflected tip with respect to joints, gravity's direction and compliances, for several
// shapes side by side.
//
// In the base, each turn has an axis z_i, a position p_i and a first moment S_i (of the loads beyond, about p_i). A
// rotation of turn j changes the moment about its own axis, or about an axis i nearer to the base, by z_i . a_j with
// a_j = (z_j x S_j) x g. It changes the moment about an axis i farther out by z_j . a_i, because dead loads have a
// potential. With rho of each beam (shape_kernel.hpp) as a further unknown, this gives a small linear system for the
// changes of the deflections when a joint turns. The diagonal is one and the other entries are of the order of a
// deflection, so the system is eliminated without pivoting. Gravity and compliances are further columns of the system.
#pragma once

#include "deflection/revolute_chain/shape_kernel.hpp"

namespace {

struct Unknown {
  int turn;
  bool is_rho;  ///< true if rho of a beam; false if the deflection of the turn
  Vec shifts;   ///< for beams: displacement of everything beyond, per unit of the unknown
  Vec a;        ///< the moment about an axis z nearer to the base changes by z . a
  Vec turns;    ///< a beam's rho changes by z . turns if an axis z nearer to the base turns
};

/// Derivatives with respect to the compliance of a turn's springs or of its beam, under constant moment.
struct Softening {
  Real given;  ///< derivative of the turn's own deflection
  Vec shift;   ///< for beams: displacement of everything beyond, except the part due to `given`
  Vec a;       ///< the moment about an axis z nearer to the base changes by z . a
};

inline constexpr int kMaxColumns = kMaxJoints + kGravityTurns + kMaxUnknowns;

struct Linearization {
  Unknown unknown[kMaxUnknowns];
  /// For each unknown: by the springs' compliance if it is a deflection, by the beam's if it is a rho.
  Softening softening[kMaxUnknowns];
  int count;
  Vec S[kMaxTurns], a[kMaxTurns];
  int width;  ///< number of entries of an equation: one per unknown, then one per variable
  Real equations[kMaxUnknowns * (kMaxUnknowns + kMaxColumns)];
  Real* row(int r) { return equations + r * width; }
};

/// Derivatives requested in addition to those with respect to joints.
struct RequestedDerivatives {
  bool gravity, compliances;
};

/// Computes the first moment of the loads beyond each turn about the turn's position, into `S`.
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

/// Derivatives of a beam's lambda and kappa with respect to the deflection of its turn and to rho.
struct BeamSlopes {
  Real lambda_by_given, kappa_by_given, lambda_by_rho, kappa_by_rho;
};

inline BeamSlopes slopesOf(const Turn& turn, const TurnState& t) {
  const Real m = turn.beam_compliance * t.moment;
  const double share = turn.beam_compliance / turn.compliance;  // derivative of m with respect to the turn's deflection
  const Real by_m = m * (1. / 3) + t.rho * t.kappa_by_m, by_rho = m * t.kappa_by_m + 2. * (t.rho * t.kappa_by_rho);
  const Real m_by_rho = -share * t.by_rho;
  return {constant(0.5 * share), share * by_m, t.lambda_by_rho + 0.5 * m_by_rho, by_rho + m_by_rho * by_m};
}

/// Return the vectors along a beam and perpendicular to it, in the base.
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

/// Returns the change of the moment about the axis of turn i per rotation of turn j.
inline Real momentBy(const Frame* frames, const Vec* a, int i, int j) {
  return i <= j ? dot(frames[i].z, a[j]) : dot(frames[j].z, a[i]);
}

/// Returns the change of the moment on turn i per unit of unknown `u`.
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
      // rho = n . (chord x g) also changes with the chord.
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

/// Adds columns for rotations of gravity about each axis of the base, starting at column `first`.
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
      // The response of a beam is proportional to its compliance, except kappa, which is proportional to the square.
      const double inverse = 1 / turn.beam_compliance;
      by.given = state.moment + inverse * (state.rho * state.by_rho);
      by.shift = inverse * state.lambda * acrossBeam(turn, frames[own.turn - 1]) -
                 2 * inverse * state.kappa * alongBeam(turn, frames[own.turn - 1]);
    }
    // The displacement due to the angle is already included in the column of the angle.
    by.shift = by.shift - by.given * lin.unknown[own.is_rho ? k - 1 : k].shifts;
    by.a = (state.size + 0.5 * turn.beam_weight) * cross(by.shift, g);
  }
}

/// Adds columns for the compliances, starting at column `first`.
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

/// Computes the derivatives of the tip pose with respect to each joint, then to the other requested variables:
/// rotations of gravity, then the compliance of each unknown (the springs of a turn, or a beam for its rho).
inline void derive(const RevoluteArm& arm, const TurnState* t, const Frame* frames, const Frame& tip, Vec gravity,
                   Real at_tip, RequestedDerivatives requested, Linearization& lin, Motion* columns) {
  outboardMoments(arm, t, frames, tip, at_tip, lin.S);
  for (int i = 0; i < arm.count; ++i) lin.a[i] = momentByTurn(frames[i].z, lin.S[i], gravity);
  addUnknowns(arm, t, frames, gravity, lin);
  lin.width =
      lin.count + arm.joints + (requested.gravity ? kGravityTurns : 0) + (requested.compliances ? lin.count : 0);
  addEquations(arm, t, frames, gravity, lin);
  for (int i = 0; i < arm.count; ++i)
    if (arm.turns[i].joint >= 0) columns[arm.turns[i].joint] = {cross(frames[i].z, tip.p - frames[i].p), frames[i].z};
  int count = arm.joints;
  if (requested.gravity) {
    addGravity(arm, frames, gravity, lin.count + count, lin);
    for (int axis = 0; axis < kGravityTurns; ++axis) columns[count++] = {none(), none()};
  }
  if (requested.compliances) {
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

/// Computes the derivatives of the tip pose with respect to each joint.
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
