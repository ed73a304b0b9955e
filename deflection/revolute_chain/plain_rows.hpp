// The rows of an arm as plain numbers: the input of the kernels that place them.
//
// Postures stand side by side: entry l of each array belongs to lane l, numbers of a posture are `stride` apart.
//
// Included by sources that are compiled for different processors: nothing here may have code of its own.
#pragma once

namespace tubeplan::deflection::simd {

inline constexpr int kMostLanes = 8;
inline constexpr int kMostRows = 48;  ///< longer arms are placed without a kernel

/// Pose p_A = R p_B + p, with R's columns one after the other.
struct PlainPose {
  double p[3], R[9];
};

/// An element of a row's member.
struct BentPiece {
  int turn;                   ///< index of its turn in the chain
  bool bends;                 ///< false: it only twists
  double compliance, others;  ///< compliance about its axis; sum of the other compliances at the same turn [rad/(N m)]
  double along[3];            ///< vector of the piece, in the row's axes [m]
  double across[3];           ///< axis x `along` [m]
  double turning[3];          ///< axis x the row's member [m]
};

/// A row's frame and, where it has a beam, its member.
struct PlainRow {
  int turn;  ///< turn that carries it; -1: the base
  PlainPose X_TL;
  bool is_at_turn;    ///< true: X_TL is the identity
  bool along_chord;   ///< true: bodies lie along the bent member's chord
  double member[3];   ///< member in the row's axes [m]
  double bow_factor;  ///< bow per rotation of the pieces, for a member in several pieces [m/rad]
  int first_piece, pieces;
};

struct PlainArm {
  const PlainRow* rows;
  const BentPiece* pieces;
  int row_count;
  PlainPose X_WB;
};

/// Output of a kernel for the postures (Shapes): 12 numbers for the tip, 12 and 4 for each turn.
struct BentShapes {
  const double *tip, *turns, *element_states;
  long stride;
};

/// Output: 12 numbers for each row, its frame in the world turned along the chord; greatest bow of a member from its
/// chord [m].
struct RowFrames {
  double* frames;
  double* bow;
  long stride;
};

/// Places the rows of as many bent arms as the kernel has lanes.
using PlaceRows = void (*)(const PlainArm&, const BentShapes&, const RowFrames&);

}  // namespace tubeplan::deflection::simd
