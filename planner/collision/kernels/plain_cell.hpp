// A cell as plain numbers: what the clearance kernels are given.
//
// Postures stand side by side: entry l of each array belongs to lane l, numbers of a posture are `stride` apart.
//
// Included by sources that are compiled for different processors: nothing here may have code of its own.
#pragma once

#include "deflection/revolute_chain/plain_rows.hpp"

namespace tubeplan::planner::kernels {

using deflection::simd::kMostLanes, deflection::simd::PlainPose;

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
