// An effect of an arm: its kind, place and values. See effects/effect.hpp for the kinds.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace tubeplan::deflection {

struct Formula;

/// Place of an effect. Members that the kind's PlaceRule does not use are -1; `row` and `other` are row indices of the
/// arm.
struct Place {
  int row = -1;
  int axis = -1;           ///< axis of the row: 0 for x, 1 for y, 2 for z
  int other = -1;          ///< row of the second joint, if the place is a pair
  std::string setup = {};  ///< name of the set-up of the base, if the place is a set-up
  bool operator==(const Place&) const = default;
};

/// An effect in internal units. `kind` is an index into effectKinds(); `values` are the values of the kind's
/// parameters, or of the formula's parameters, in order.
template <class S>
struct EffectOf {
  int kind = -1;
  Place place;
  std::vector<S> values;
  std::shared_ptr<const Formula> formula = nullptr;  ///< formula of a user-defined effect; see effects/formula.hpp
};
using Effect = EffectOf<double>;

}  // namespace tubeplan::deflection
