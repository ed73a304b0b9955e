// A cell as plain numbers: the input of the clearance kernels.
//
// Postures stand side by side: entry l of each array belongs to lane l, numbers of a posture are `stride` apart.
//
// Included by sources that are compiled for different processors: nothing here may have code of its own.
#pragma once

#include "deflection/revolute_chain/plain_rows.hpp"

namespace tubeplan::planner::kernels {

using deflection::simd::kMostLanes, deflection::simd::PlainPose;

/// A capsule in the frame of the row that carries it; around the body, if that is another solid.
struct PlainBody {
  int row;
  double from[3], to[3], radius, half_length;
};

/// An obstacle [m]; numbers that a kind of pair does not need are zero.
struct PlainObstacle {
  double from[3], to[3];       ///< ends of a capsule; `from` is a point of a plane or the centre of a sphere
  double normal[3];            ///< normal of a plane, of length 1
  double radius, half_length;  ///< sizes of a sphere, a capsule, or a cylinder about z of C
  double half[3];              ///< half sizes of a box along the axes of C
  PlainPose X_CW;
};

enum PairKind { kBodyAndBody, kPlane, kSphereInside, kFixedCapsule, kBox, kCylinder };

struct PlainPair {
  PairKind kind;
  int body, other;
};

/// A scene, with the pairs first whose distance the kernel computes, then those for which it computes a lower bound.
struct PlainScene {
  const PlainBody* bodies;
  const PlainObstacle* obstacles;
  const PlainPair* pairs;
  int body_count, exact_count, pair_count;
};

struct FoundPairs {
  double* ends;      ///< 6 for each body: both ends in the world
  double* distance;  ///< least distance of the exact pairs [m]
  double* nearest;   ///< index of that pair; -1 if there is none
  double* bounds;    ///< lower bounds of the other pairs, one for each [m]
  long stride;
};

}  // namespace tubeplan::planner::kernels
