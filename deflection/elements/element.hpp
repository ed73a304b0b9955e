// The flexible elements of a row: each turns the loading of a component into its deflection, by one law in one file.
#pragma once

#include <span>

#include "deflection/arm.hpp"

namespace tubeplan::deflection {

/// How an element of a row gives, worked out once for every load.
template <class S>
struct Flexibility {
  Vector3<S> member = Vector3<S>::Zero();      ///< near to far end, undeflected [m]
  Matrix3<S> compliance = Matrix3<S>::Zero();  ///< rotation of the far end per moment along all of it [rad/(N m)]
  bool has_soft_zone = false;                  ///< see joint_stiffness.hpp ...
  Vector3<S> softness = Vector3<S>::Zero();    ///< ... rad/(N m) more about each axis ...
  Vector3<S> knee = Vector3<S>::Zero();        ///< ... up to this moment [N m]
};

/// What acts on an element, in the row's own (deflected) axes. N, N m, m.
template <class S>
struct Loading {
  Vector3<S> force;   ///< on the far end, from everything beyond
  Vector3<S> moment;  ///< about the far end, from everything beyond
  Vector3<S> weight;  ///< total of the weight distributed along the element
  Vector3<S> chord;   ///< near to far end as deflected in the last pass: the true moment arm
};

/// Motion of the far end against the near end: displacement of its origin [m], then rotation about that origin [rad].
template <class S>
struct Deflection {
  Vector3<S> displacement = Vector3<S>::Zero();
  Vector3<S> rotation = Vector3<S>::Zero();
};

/// How a deflection changes with the loading: of displacement and rotation, by force, moment, weight and chord.
struct DeflectionSlopes {
  using Block = Eigen::Matrix3d;
  Block displacement_by_force = Block::Zero(), displacement_by_moment = Block::Zero(),
        displacement_by_weight = Block::Zero(), displacement_by_chord = Block::Zero();
  Block rotation_by_force = Block::Zero(), rotation_by_moment = Block::Zero(), rotation_by_weight = Block::Zero(),
        rotation_by_chord = Block::Zero();
};

/// Where an element sits in its row: at the origin, or along the member (split into the beam's segments).
enum class ElementPlace { kOrigin, kMember };

/// One row of the element table. A new law is a new file with the templates `flexibilityOf` and `deflect` and the
/// slopes of the latter, and a row in elements.cpp.
struct ElementKind {
  const char* key;  ///< the row's key in the arm file
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
