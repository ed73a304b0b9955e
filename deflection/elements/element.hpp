// Flexible elements of a row. Each deflects under its load by a law that is stated in a separate file.
#pragma once

#include <span>

#include "deflection/arm.hpp"

namespace tubeplan::deflection {

/// Load-independent flexibility of a row's element.
template <class S>
struct Flexibility {
  Vector3<S> member = Vector3<S>::Zero();  ///< vector from near to far end, undeflected [m]
  /// Rotation of the far end per moment that is constant along the element [rad/(N m)].
  Matrix3<S> compliance = Matrix3<S>::Zero();
  bool has_soft_zone = false;                ///< see joint_stiffness.hpp
  Vector3<S> softness = Vector3<S>::Zero();  ///< additional compliance about each axis below the knee [rad/(N m)]
  Vector3<S> knee = Vector3<S>::Zero();      ///< knee moment [N m]
};

/// Load on an element, in the row's own (deflected) axes [N, N m, m].
template <class S>
struct Loading {
  Vector3<S> force;   ///< total outboard force on the far end
  Vector3<S> moment;  ///< total outboard moment about the far end
  Vector3<S> weight;  ///< total weight distributed along the element
  Vector3<S> chord;   ///< vector from near to far end, deflected as in the last pass
};

/// Motion of the far end relative to the near end: displacement of the far end's origin [m], then rotation about that
/// origin [rad].
template <class S>
struct Deflection {
  Vector3<S> displacement = Vector3<S>::Zero();
  Vector3<S> rotation = Vector3<S>::Zero();
};

/// Derivatives of a deflection's displacement and rotation with respect to force, moment, weight and chord.
struct DeflectionSlopes {
  using Block = Eigen::Matrix3d;
  Block displacement_by_force = Block::Zero(), displacement_by_moment = Block::Zero(),
        displacement_by_weight = Block::Zero(), displacement_by_chord = Block::Zero();
  Block rotation_by_force = Block::Zero(), rotation_by_moment = Block::Zero(), rotation_by_weight = Block::Zero(),
        rotation_by_chord = Block::Zero();
};

/// Place of an element in its row: at the origin, or along the member, which is split into the beam's segments.
enum class ElementPlace { kOrigin, kMember };

/// A kind of element: one row of the element table. A new law needs a new file with the templates `flexibilityOf` and
/// `deflect` and the function `slopesOf`, and a row in elements.cpp.
struct ElementKind {
  const char* key;  ///< key of the element's parameters in the arm file
  const char* law;
  ElementPlace place;
  bool (*isFlexible)(const Row<double>&);
  int (*segments)(const Row<double>&);
  Flexibility<double> (*flexibilityOf)(const Row<double>&, const Vector3<double>& member);
  Flexibility<Dual> (*flexibilityOfDual)(const Row<Dual>&, const Vector3<Dual>& member);
  Deflection<double> (*deflect)(const Flexibility<double>&, const Loading<double>&);
  Deflection<Dual> (*deflectDual)(const Flexibility<Dual>&, const Loading<double>&);
  DeflectionSlopes (*slopesOf)(const Flexibility<double>&, const Loading<double>&);
};

std::span<const ElementKind> elementKinds();

}  // namespace tubeplan::deflection
