// The flexible elements of a row: each turns the loading of a component into its deflection, by one law in one file.
#pragma once

#include <span>

#include "deflection/arm.hpp"

namespace tubeplan::deflection {

/// What acts on an element, in the row's own (deflected) axes. N, N m, m.
template <class S>
struct Loading {
  Vector3<S> force;   ///< on the far end, from everything beyond
  Vector3<S> moment;  ///< about the far end, from everything beyond
  Vector3<S> weight;  ///< total of the weight distributed along the element
  Vector3<S> member;  ///< near to far end, undeflected
  Vector3<S> chord;   ///< near to far end as deflected in the last iteration: the true moment arm
};

/// Motion of the far end against the near end: displacement of its origin [m], then rotation about that origin [rad].
template <class S>
struct Deflection {
  Vector3<S> displacement = Vector3<S>::Zero();
  Vector3<S> rotation = Vector3<S>::Zero();
};

/// Where an element sits in its row: at the origin, or along the member (split into the beam's segments).
enum class ElementPlace { kOrigin, kMember };

/// One row of the element table. A new law is a new file with a `deflect` template, and a row in elements.cpp.
struct ElementKind {
  const char* key;  ///< the row's key in the arm file
  const char* law;
  ElementPlace place;
  bool (*isFlexible)(const Row<double>&);
  int (*segments)(const Row<double>&);
  Deflection<double> (*deflect)(const Row<double>&, const Loading<double>&);
  Deflection<Dual> (*deflectDual)(const Row<Dual>&, const Loading<Dual>&);
};

std::span<const ElementKind> elementKinds();

}  // namespace tubeplan::deflection
