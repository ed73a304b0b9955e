// Frames of the rows of several bent arms, side by side. See plain_rows.hpp for the input, lanes.hpp for the SIMD
// numbers.
//
// Bodies of a bent member lie along its chord: the row's axes are rotated by the smallest rotation that takes the
// member to the chord. The distance of the member from the chord is evaluated at five points of a cubic. The cubic is
// defined by the displacement d and the rotation w of the member's end: (3 s^2 - 2 s^3 - s) d + (s^3 - s^2) w x member.
#pragma once

#include "deflection/revolute_chain/lanes.hpp"
#include "deflection/revolute_chain/plain_rows.hpp"

namespace {

using namespace tubeplan::deflection::simd;

constexpr double kBowPlaces[] = {0.25, 1. / 3, 0.5, 2. / 3, 0.75};

struct RowFrame {
  Vec x, y, z, p;
};

inline Vec loadVec(const double* from, long stride) {
  return {load(from), load(from + stride), load(from + 2 * stride)};
}

inline void storeLanes(double* to, long stride, Vec v) {
  store(to, v.x);
  store(to + stride, v.y);
  store(to + 2 * stride, v.z);
}

inline RowFrame loadFrame(const double* from, long stride) {
  return {loadVec(from + 3 * stride, stride), loadVec(from + 6 * stride, stride), loadVec(from + 9 * stride, stride),
          loadVec(from, stride)};
}

inline void storeFrameOf(const RowFrame& X, double* to, long stride) {
  storeLanes(to, stride, X.p);
  storeLanes(to + 3 * stride, stride, X.x);
  storeLanes(to + 6 * stride, stride, X.y);
  storeLanes(to + 9 * stride, stride, X.z);
}

inline Vec same(const double* v) { return {constant(v[0]), constant(v[1]), constant(v[2])}; }

/// Converts the direction v from frame X to the axes in which X is given.
inline Vec turned(const RowFrame& X, const double* v) {
  return (constant(v[0]) * X.x + constant(v[1]) * X.y) + constant(v[2]) * X.z;
}
inline Vec placed(const RowFrame& X, const double* p) { return X.p + turned(X, p); }

inline RowFrame fixedFrame(const PlainPose& X) { return {same(X.R), same(X.R + 3), same(X.R + 6), same(X.p)}; }

inline RowFrame frameIn(const RowFrame& X, const PlainPose& Y) {
  return {turned(X, Y.R), turned(X, Y.R + 3), turned(X, Y.R + 6), placed(X, Y.p)};
}

/// Apply a constant pose to a vector or a frame in each lane.
inline Vec turnedBy(const PlainPose& X, Vec v) { return (v.x * same(X.R) + v.y * same(X.R + 3)) + v.z * same(X.R + 6); }

inline RowFrame movedBy(const PlainPose& X, const RowFrame& Y) {
  return {turnedBy(X, Y.x), turnedBy(X, Y.y), turnedBy(X, Y.z), same(X.p) + turnedBy(X, Y.p)};
}

inline Vec unit(Vec v) { return (constant(1) / squareRoot(dot(v, v))) * v; }

/// Rotates the axes of X by the smallest rotation that takes the direction `member` to the direction `chord`.
inline void turnAlong(Vec member, Vec chord, RowFrame& X) {
  const Vec from = unit(member), to = unit(chord), axis = cross(from, to);
  const Real factor = 1. / (1. + dot(from, to));
  const auto turn = [&](Vec v) {
    const Vec once = cross(axis, v);
    return (v + once) + factor * cross(axis, once);
  };
  X.x = turn(X.x);
  X.y = turn(X.y);
  X.z = turn(X.z);
}

inline Real angleOf(const BentPiece& piece, const BentShapes& in) {
  const double* element_states = in.element_states + 4 * piece.turn * in.stride;
  const Real moment = load(element_states);
  return piece.bends ? load(element_states + in.stride) - piece.others * moment : piece.compliance * moment;
}

/// Returns the square of the largest distance of a piece from its chord [m^2].
inline Real squaredBow(const BentPiece& piece, const BentShapes& in) {
  const double* element_states = in.element_states + 4 * piece.turn * in.stride;
  const Real lambda = piece.bends ? load(element_states + 2 * in.stride) : constant(0),
             kappa = piece.bends ? load(element_states + 3 * in.stride) : constant(0);
  const Vec d = lambda * same(piece.across) - kappa * same(piece.along);
  const Vec slope = angleOf(piece, in) * same(piece.turning);
  Real most = constant(0);
  for (const double s : kBowPlaces) {
    const Vec off = constant(3 * s * s - 2 * s * s * s - s) * d + constant(s * s * s - s * s) * slope;
    most = greatest(most, dot(off, off));
  }
  return most;
}

inline Real bowOf(const PlainArm& arm, const PlainRow& row, const BentShapes& in) {
  const BentPiece* pieces = arm.pieces + row.first_piece;
  if (row.pieces == 0) return constant(0);
  if (row.pieces == 1) return 1.1 * squareRoot(squaredBow(*pieces, in));
  Real turn = constant(0);
  for (int k = 0; k < row.pieces; ++k) turn = turn + absolute(angleOf(pieces[k], in));
  return row.bow_factor * turn;
}

inline void placeRows(const PlainArm& arm, const BentShapes& in, const RowFrames& out) {
  RowFrame rows[kMostRows];
  const RowFrame base = fixedFrame({{0, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 1}});
  for (int i = 0; i < arm.row_count; ++i) {
    const PlainRow& row = arm.rows[i];
    const RowFrame turn = row.turn < 0 ? base : loadFrame(in.turns + 12 * row.turn * in.stride, in.stride);
    rows[i] = row.is_at_turn ? turn : frameIn(turn, row.X_TL);
  }
  Real bow = constant(0);
  for (int i = 0; i < arm.row_count; ++i) {
    const PlainRow& row = arm.rows[i];
    RowFrame X = rows[i];
    if (row.along_chord) {
      const Vec end = i + 1 < arm.row_count ? rows[i + 1].p : loadVec(in.tip, in.stride);
      turnAlong(turned(X, row.member), end - X.p, X);
      bow = greatest(bow, bowOf(arm, row, in));
    }
    storeFrameOf(movedBy(arm.X_WB, X), out.frames + 12 * i * out.stride, out.stride);
  }
  store(out.bow, bow);
}

}  // namespace
