// An effect of an arm: its law, place and numbers. The laws are in effects/effect.hpp.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace tubeplan::deflection {

struct Formula;

/// Place of an effect; numbers that its rule does not use are -1. Indices are those of the arm's rows.
struct Place {
  int row = -1;
  int axis = -1;           ///< 0, 1, 2: x, y, z of the row
  int other = -1;          ///< row of the second joint, if the place is a pair
  std::string setup = {};  ///< set-up of the base, if the place is a set-up
  bool operator==(const Place&) const = default;
};

/// An effect in internal units. `kind` indexes effectKinds(); `values` are the kind's parameters, or those of its
/// formula, in order.
template <class S>
struct EffectOf {
  int kind = -1;
  Place place;
  std::vector<S> values;
  std::shared_ptr<const Formula> formula = nullptr;  ///< formula of a user's effect; see effects/formula.hpp
};
using Effect = EffectOf<double>;

}  // namespace tubeplan::deflection
