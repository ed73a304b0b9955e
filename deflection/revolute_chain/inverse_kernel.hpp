// Newton's method on position and pitch of the deflected tip, for several goals side by side. inverse_kinematics.cpp
// provides the goals, and repeats the iteration with damping for goals that are not met.
#pragma once

#include "deflection/revolute_chain/jacobian_kernel.hpp"

namespace {

/// Position error [m] and pitch error times the reach, and their derivatives with respect to the joints. The
/// derivatives are divided by the reach.
struct GoalResidual {
  Real value[4], slope[4][4];
  Real position_error, pitch, tilt_sine, tilt_cosine;
};

inline Vec constantVec(const double* v) { return {constant(v[0]), constant(v[1]), constant(v[2])}; }
inline Vec loadVec(const double (*from)[8]) { return {load(from[0]), load(from[1]), load(from[2])}; }

inline Vec turned(const Frame& X, const double* v) {
  return constant(v[0]) * X.x + constant(v[1]) * X.y + constant(v[2]) * X.z;
}

/// Shapes at the last trial readings, and directions of the tool in base axes.
struct Tried {
  TurnState t[kMaxTurns];
  Frame frames[kMaxTurns], tip;
  Vec axis, hand, tilt;
};

/// Computes the residual at the readings in `in`, without derivatives. Returns the mask of the lanes whose shape
/// converges.
inline Bits tryReadings(const RevoluteArm& arm, const Tool& tool, const Goals& goals, const Postures& in, Tried& tried,
                        GoalResidual& out) {
  const Vec n = loadVec(goals.axis_B);
  const Real at_tip = load(goals.load);
  begin(arm, in, at_tip, tried.t);
  const Real sweeps = converge(arm, in, loadVec(goals.gravity_B), at_tip, tried.t);
  tried.tip = placeFrames(arm, tried.t, tried.frames);
  tried.axis = turned(tried.tip, tool.axis);
  tried.hand = turned(tried.frames[tool.hand], tool.hand_axis);
  tried.tilt = cross(tried.axis, n);
  const Vec off = tried.tip.p - loadVec(goals.p_BT);
  out.position_error = squareRoot(dot(off, off));
  out.pitch = dot(tried.hand, tried.tilt);
  out.tilt_sine = squareRoot(dot(tried.tilt, tried.tilt));
  out.tilt_cosine = dot(tried.axis, n);
  out.value[0] = off.x;
  out.value[1] = off.y;
  out.value[2] = off.z;
  out.value[3] = arm.reach * out.pitch;
  return isAtMost(constant(0), sweeps);
}

/// Adds the derivatives of the residual with respect to the readings, divided by the reach.
inline void addSlopes(const RevoluteArm& arm, const Goals& goals, const Tried& tried, GoalResidual& out) {
  Motion columns[kMaxJoints];
  deriveByJoints(arm, tried.t, tried.frames, tried.tip, loadVec(goals.gravity_B), load(goals.load), columns);
  const Vec n = loadVec(goals.axis_B);
  const double share = 1 / arm.reach;
  for (int j = 0; j < 4; ++j) {
    const Vec w = columns[j].w;
    out.slope[0][j] = columns[j].p.x * share;
    out.slope[1][j] = columns[j].p.y * share;
    out.slope[2][j] = columns[j].p.z * share;
    out.slope[3][j] = dot(cross(w, tried.hand), tried.tilt) + dot(tried.hand, cross(cross(w, tried.axis), n));
  }
}

/// Computes the adjugate of the 4 x 4 matrix `a`; returns the determinant of `a`.
inline Real adjugateOf(const Real (*a)[4], Real (*adj)[4]) {
  const Real s0 = a[0][0] * a[1][1] - a[1][0] * a[0][1], s1 = a[0][0] * a[1][2] - a[1][0] * a[0][2],
             s2 = a[0][0] * a[1][3] - a[1][0] * a[0][3], s3 = a[0][1] * a[1][2] - a[1][1] * a[0][2],
             s4 = a[0][1] * a[1][3] - a[1][1] * a[0][3], s5 = a[0][2] * a[1][3] - a[1][2] * a[0][3];
  const Real c5 = a[2][2] * a[3][3] - a[3][2] * a[2][3], c4 = a[2][1] * a[3][3] - a[3][1] * a[2][3],
             c3 = a[2][1] * a[3][2] - a[3][1] * a[2][2], c2 = a[2][0] * a[3][3] - a[3][0] * a[2][3],
             c1 = a[2][0] * a[3][2] - a[3][0] * a[2][2], c0 = a[2][0] * a[3][1] - a[3][0] * a[2][1];
  for (int k = 0; k < 2; ++k) {
    // Each cofactor combines the other row of its half of the matrix with minors of the other half; signs alternate.
    const Real* u = a[1 - k];
    const Real* l = a[3 - k];
    const double sign = k == 0 ? 1 : -1;
    adj[0][k] = sign * ((u[1] * c5 - u[2] * c4) + u[3] * c3);
    adj[1][k] = -sign * ((u[0] * c5 - u[2] * c2) + u[3] * c1);
    adj[2][k] = sign * ((u[0] * c4 - u[1] * c2) + u[3] * c0);
    adj[3][k] = -sign * ((u[0] * c3 - u[1] * c1) + u[2] * c0);
    adj[0][2 + k] = sign * ((l[1] * s5 - l[2] * s4) + l[3] * s3);
    adj[1][2 + k] = -sign * ((l[0] * s5 - l[2] * s2) + l[3] * s1);
    adj[2][2 + k] = sign * ((l[0] * s4 - l[1] * s2) + l[3] * s0);
    adj[3][2 + k] = -sign * ((l[0] * s3 - l[1] * s1) + l[2] * s0);
  }
  return ((s0 * c5 - s1 * c4) + (s2 * c3 + s3 * c2)) + (s5 * c0 - s4 * c1);
}

/// Returns the smallest singular value, from the smallest root of the characteristic polynomial of J^T J. Newton's
/// method, started from zero, converges to that root without overshooting.
inline Real smallestSingularValue(const Real (*slope)[4], const Real (*adjugate)[4], Real determinant) {
  Real gram[4][4], trace = constant(0), squares = constant(0), c1 = constant(0);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      gram[i][j] = (slope[0][i] * slope[0][j] + slope[1][i] * slope[1][j]) +
                   (slope[2][i] * slope[2][j] + slope[3][i] * slope[3][j]);
      squares = squares + gram[i][j] * gram[i][j];
      c1 = c1 + adjugate[i][j] * adjugate[i][j];
    }
  for (int i = 0; i < 4; ++i) trace = trace + gram[i][i];
  const Real c0 = determinant * determinant, c2 = 0.5 * (trace * trace - squares);
  Real x = constant(0);
  for (int k = 0; k < 12; ++k) {
    const Real value = c0 - x * (c1 - x * (c2 - x * (trace - x)));
    const Real slope_of = c1 - x * (2. * c2 - x * (3. * trace - 4. * x));
    const Bits falls = isLess(constant(0), slope_of) & isLess(constant(0), value);
    x = select(falls, x + value / select(falls, slope_of, constant(1)), x);
  }
  return squareRoot(x);
}

inline Real largest(const Real* v) {
  Real most = absolute(v[0]);
  for (int k = 1; k < 4; ++k) most = select(isLess(most, absolute(v[k])), absolute(v[k]), most);
  return most;
}

inline void record(Bits lanes, double verdict, const GoalResidual& r, Real singular, Real steps, Reached& out) {
  const auto put = [lanes](double* to, Real x) { store(to, select(lanes, x, load(to))); };
  put(out.done, constant(verdict));
  put(out.steps, steps);
  put(out.position_error, r.position_error);
  put(out.tilt_sine, r.tilt_sine);
  put(out.tilt_cosine, r.tilt_cosine);
  put(out.smallest_singular_value, singular);
}

/// Computes the Newton step for each lane, limited to half a radian per joint. `adjugate` and `determinant` belong to
/// the Jacobian scaled by `share`.
inline void stepOf(const GoalResidual& r, const Real (*adjugate)[4], Real determinant, double share, Bits lanes,
                   Real* step) {
  Real next[4];
  const Real scale = -share / determinant;
  for (int i = 0; i < 4; ++i)
    next[i] = scale * ((adjugate[i][0] * r.value[0] + adjugate[i][1] * r.value[1]) +
                       (adjugate[i][2] * r.value[2] + adjugate[i][3] * r.value[3]));
  const Real longest = largest(next);
  const Real shorter = select(isLess(constant(0.5), longest), 0.5 / longest, constant(1));
  for (int i = 0; i < 4; ++i) step[i] = select(lanes, shorter * next[i], step[i]);
}

/// Iterates each lane until its goal is met. With damping, a step that does not reduce the residual is halved; without
/// damping, the lane is abandoned at once.
inline void meetGoals(const RevoluteArm& arm, const Tool& tool, const Goals& goals, Reached& out) {
  Real at[4], step[4];
  for (int j = 0; j < 4; ++j) {
    step[j] = constant(0);
    store(out.q[j], at[j] = load(goals.start[j]));
  }
  store(out.done, constant(0));
  store(out.steps, constant(0));
  const Postures in{&out.q[0][0], goals.load, &goals.gravity_B[0][0], 8, goals.tolerance, goals.max_sweeps};
  Tried tried;
  const Bits all = isAtMost(constant(0), constant(0));
  Bits active = all, closing = all ^ all;
  Real nearest = constant(1e300), damping = constant(1), steps = constant(-1);
  while (any(active)) {
    GoalResidual r;
    const Bits is_converged = tryReadings(arm, tool, goals, in, tried, r);
    const Real size =
        (r.value[0] * r.value[0] + r.value[1] * r.value[1]) + (r.value[2] * r.value[2] + r.value[3] * r.value[3]);
    const Bits nearer = active & is_converged & ~closing & isLess(size, nearest);
    const Bits met = nearer & isLess(r.position_error, constant(goals.position_tolerance)) &
                     isLess(absolute(r.pitch), constant(goals.pitch_tolerance)) & isLess(constant(0), r.tilt_cosine);
    steps = select(nearer, steps + 1., steps);
    const Bits ends = active & (met | closing);
    if (any(nearer | ends)) {
      Real adjugate[4][4];
      addSlopes(arm, goals, tried, r);
      const Real determinant = adjugateOf(r.slope, adjugate);
      stepOf(r, adjugate, determinant, 1 / arm.reach, nearer, step);
      if (any(ends)) {
        const Real singular = smallestSingularValue(r.slope, adjugate, determinant);
        record(met, 1, r, singular, steps, out);
        record(active & closing, 2, r, singular, steps, out);
      }
    }
    nearest = select(nearer, size, nearest);
    for (int j = 0; j < 4; ++j) at[j] = select(nearer, load(out.q[j]), at[j]);
    damping = select(nearer, constant(1), 0.5 * damping);
    active = active & ~ends;
    // A lane is abandoned if its first posture fails. Without damping it is also abandoned if a step fails or is too
    // short, or after too many steps.
    const Bits lost = isLess(steps, constant(0)) | (goals.damped ? all ^ all : ~nearer);
    active = active & ~lost;
    closing = active & (isLess(constant(goals.max_steps), steps + 1.) | isLess(damping, constant(1e-4)) |
                        isLess(damping * largest(step), constant(1e-12)));
    if (!goals.damped) active = active & ~closing;
    for (int j = 0; j < 4; ++j)
      store(out.q[j], select(active, select(closing, at[j], at[j] + damping * step[j]), load(out.q[j])));
  }
}

}  // namespace
