// A cell as plain numbers: what the clearance kernels are given.
//
// Postures stand side by side: entry l of each array belongs to lane l, numbers of a posture are `stride` apart.
//
// Included by sources that are compiled for different processors: nothing here may have code of its own.
#pragma once

namespace tubeplan::planner::kernels {

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

/// What the deflection kernel says of the postures (hinges::Shapes): 12 numbers for the tip, 12 and 4 for each turn.
struct BentShapes {
  const double *tip, *turns, *element_states;
  long stride;
};

/// 12 numbers for each row: its frame in the world, turned along the chord; greatest bow of a member from its chord.
struct PlacedRows {
  double* frames;
  double* bow;
  long stride;
};

/// A capsule carried by a row, in its frame. Around the body, where that is another solid.
struct PlainBody {
  int row;
  double from[3], to[3], radius, half_length;
};

/// [m]; what a kind of pair does not need is nothing.
struct PlainObstacle {
  double from[3], to[3];       ///< of a capsule; `from` of a plane is a point of it, of a sphere its centre
  double normal[3];            ///< of a plane, of length 1
  double radius, half_length;  ///< of a sphere, a capsule, or a cylinder about z of C
  double half[3];              ///< of the sizes of a box along the axes of C
  PlainPose X_CW;
};

enum PairKind { kBodyAndBody, kPlane, kSphereInside, kFixedCapsule, kBox, kCylinder };

struct PlainPair {
  PairKind kind;
  int body, other;
};

/// First the pairs whose distance the kernel gives, then those of which it gives a lower bound.
struct PlainScene {
  const PlainBody* bodies;
  const PlainObstacle* obstacles;
  const PlainPair* pairs;
  int body_count, exact_count, pair_count;
};

struct FoundPairs {
  double* ends;      ///< 6 for each body: from and to in the world
  double* distance;  ///< least of the exact pairs [m]
  double* nearest;   ///< which one; -1 where there is none
  double* bounds;    ///< for each of the other pairs
  long stride;
};

}  // namespace tubeplan::planner::kernels
