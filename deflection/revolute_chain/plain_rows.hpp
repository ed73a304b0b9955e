// The rows of an arm as plain numbers: the input of the kernels that place rows.
//
// Postures are stored side by side: entry l of each array belongs to lane l, and the values of one posture are `stride`
// apart.
//
// Source files that are compiled for different processors include this header, so it must not define functions.
#pragma once

namespace tubeplan::deflection::simd {

inline constexpr int kMostLanes = 8;
inline constexpr int kMostRows = 48;  ///< longer arms are placed without a kernel

/// Pose p_A = R p_B + p, with the columns of R one after the other.
struct PlainPose {
  double p[3], R[9];
};

/// An element of a row's member.
struct BentPiece {
  int turn;    ///< index in the chain of the turn that the piece deflects
  bool bends;  ///< false if the piece only twists
  /// Compliance of the piece, and sum of the other compliances about the turn's axis [rad/(N m)].
  double compliance, others;
  double along[3];    ///< vector of the piece, in the row's axes [m]
  double across[3];   ///< cross product of the turn's axis and `along` [m]
  double turning[3];  ///< cross product of the turn's axis and the row's member [m]
};

/// A row's frame and, if the row has a beam, its member.
struct PlainRow {
  int turn;  ///< index of the turn that carries the row; -1 means the base
  PlainPose X_TL;
  bool is_at_turn;   ///< true if X_TL is the identity
  bool along_chord;  ///< true if bodies lie along the bent member's chord
  double member[3];  ///< member in the row's axes [m]
  /// For a member of several pieces, largest distance from the chord per sum of the pieces' rotations [m/rad].
  double bow_factor;
  int first_piece, pieces;
};

struct PlainArm {
  const PlainRow* rows;
  const BentPiece* pieces;
  int row_count;
  PlainPose X_WB;
};

/// A kernel's results for the postures (see Shapes): 12 values for the tip's pose and, for each turn, 12 for its frame
/// and 4 for its element state.
struct BentShapes {
  const double *tip, *turns, *element_states;
  long stride;
};

/// Output: 12 values for each row, the row's frame in the world rotated along its member's chord; and the largest
/// distance of a bent member from its chord [m].
struct RowFrames {
  double* frames;
  double* bow;
  long stride;
};

/// Places the rows of as many bent arms at once as the kernel has lanes.
using PlaceRows = void (*)(const PlainArm&, const BentShapes&, const RowFrames&);

}  // namespace tubeplan::deflection::simd
