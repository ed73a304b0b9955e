// An effect as an arm carries it: which law, where, and its numbers. The laws are in effects/effect.hpp.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace tubeplan::deflection {

struct Formula;

/// Where an effect acts; -1 where its rule has no use for the number. Indices are those of the arm's rows.
struct Place {
  int row = -1;
  int axis = -1;           ///< 0, 1, 2: x, y, z of the row
  int other = -1;          ///< the row of the second joint, where a place is a pair
  std::string setup = {};  ///< of the base, where a place is a set-up
  bool operator==(const Place&) const = default;
};

/// `kind` indexes effectKinds(); `values` are the kind's parameters, or those of its formula, in their order, in
/// internal units.
template <class S>
struct EffectOf {
  int kind = -1;
  Place place;
  std::vector<S> values;
  std::shared_ptr<const Formula> formula = nullptr;  ///< of an effect that the user writes; see effects/formula.hpp
};
using Effect = EffectOf<double>;

}  // namespace tubeplan::deflection
