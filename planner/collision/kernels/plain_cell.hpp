// A cell as arrays of plain numbers: the input of the clearance kernels.
//
// Postures are side by side: entry l of each array belongs to lane l, and consecutive values of a posture are `stride`
// apart.
//
// This header must not define functions: it is included by sources that are compiled for different processors, and the
// linker might keep the code for the wrong processor.
#pragma once

#include "deflection/revolute_chain/plain_rows.hpp"

namespace tubeplan::planner::kernels {

using deflection::simd::kMostLanes, deflection::simd::PlainPose;

/// A capsule in the frame of the row that carries it [m]: the body itself, or a capsule around a body of another shape.
struct PlainBody {
  int row;
  double from[3], to[3], radius, half_length;
};

/// An obstacle [m] in the world W or, if it is a box or a cylinder, in its own frame C. Values that the kind of pair
/// does not need are zero.
struct PlainObstacle {
  double from[3], to[3];  ///< ends of a capsule; `from` is a point of a plane or the centre of a sphere
  double normal[3];       ///< normal of a plane, of length 1
  /// Radius of a sphere, or radius and half length of a capsule or of a cylinder about z of C.
  double radius, half_length;
  double half[3];  ///< half edge lengths of a box along the axes of C
  PlainPose X_CW;
};

enum PairKind { kBodyAndBody, kPlane, kSphereInside, kFixedCapsule, kBox, kCylinder };

struct PlainPair {
  PairKind kind;
  int body, other;
};

/// A scene. Pairs whose distance the kernel computes exactly come first, then pairs for which it computes a lower
/// bound.
struct PlainScene {
  const PlainBody* bodies;
  const PlainObstacle* obstacles;
  const PlainPair* pairs;
  int body_count, exact_count, pair_count;
};

struct FoundPairs {
  double* ends;      ///< six values for each body: both ends of its capsule in the world [m]
  double* distance;  ///< smallest distance over the exact pairs [m]
  double* nearest;   ///< index of the exact pair with the smallest distance; -1 if there is none
  /// Lower bounds of the distances of the pairs after the exact pairs, one for each pair [m]; infinite where the bound
  /// is not below `distance`.
  double* bounds;
  long stride;
};

}  // namespace tubeplan::planner::kernels
