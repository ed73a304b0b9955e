// The rows of an arm as plain numbers: what the kernels that place them are given.
//
// Postures stand side by side: entry l of each array belongs to lane l, numbers of a posture are `stride` apart.
//
// Included by sources that are compiled for different processors: nothing here may have code of its own.
#pragma once

namespace tubeplan::deflection::simd {

inline constexpr int kMostLanes = 8;
inline constexpr int kMostRows = 48;  ///< a longer arm is placed without a kernel

/// p_A = R p_B + p; R's columns one after the other.
struct PlainPose {
  double p[3], R[9];
};

/// An element of a row's member.
struct BentPiece {
  int turn;                   ///< of the chain
  bool bends;                 ///< else it only twists
  double compliance, others;  ///< about its axis; of all else that gives about it at the same turn [rad/(N m)]
  double along[3];            ///< the piece, in the row's axes [m]
  double across[3];           ///< its axis x the piece
  double turning[3];          ///< its axis x the row's member
};

/// A row's frame and, where it has a beam, its member.
struct PlainRow {
  int turn;  ///< that it is fixed to; -1: the base
  PlainPose X_TL;
  bool is_at_turn;    ///< X_TL is the identity
  bool along_chord;   ///< bodies lie along the bent member's chord
  double member[3];   ///< in the row's axes [m]
  double bow_factor;  ///< of a member in several pieces: bow for each radian that they turn [m/rad]
  int first_piece, pieces;
};

struct PlainArm {
  const PlainRow* rows;
  const BentPiece* pieces;
  int row_count;
  PlainPose X_WB;
};

/// What a kernel says of the postures (Shapes): 12 numbers for the tip, 12 and 4 for each turn.
struct BentShapes {
  const double *tip, *turns, *element_states;
  long stride;
};

/// 12 numbers for each row: its frame in the world, turned along the chord; greatest bow of a member from its chord.
struct RowFrames {
  double* frames;
  double* bow;
  long stride;
};

/// Places the rows of as many bent arms as the kernel has lanes.
using PlaceRows = void (*)(const PlainArm&, const BentShapes&, const RowFrames&);

}  // namespace tubeplan::deflection::simd
