// The rows of an arm as plain numbers: the input of the kernels that place rows.
//
// Postures are stored side by side: entry l of each array belongs to lane l, and the values of one posture are `stride`
// apart.
//
// Included by source files that are compiled for different processors, so nothing here may generate code.
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
  int turn;                   ///< index in the chain of the turn that the piece deflects
  bool bends;                 ///< false: the piece only twists
  double compliance, others;  ///< compliance about the turn's axis; sum of other compliances there [rad/(N m)]
  double along[3];            ///< vector of the piece, in the row's axes [m]
  double across[3];           ///< cross product of the turn's axis and `along` [m]
  double turning[3];          ///< cross product of the turn's axis and the row's member [m]
};

/// A row's frame and, if the row has a beam, its member.
struct PlainRow {
  int turn;  ///< index of the turn that carries the row; -1: the base
  PlainPose X_TL;
  bool is_at_turn;    ///< true: X_TL is the identity
  bool along_chord;   ///< true: bodies lie along the bent member's chord
  double member[3];   ///< member in the row's axes [m]
  double bow_factor;  ///< bow per sum of the pieces' rotations, for a member of several pieces [m/rad]
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
