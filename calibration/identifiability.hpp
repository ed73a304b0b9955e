// What readings can tell of a set of unknowns, and what they cannot.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

struct IdentifiabilityOptions {
  double least_share = 1e-5;  ///< of a column's length that must be its own, for the number to be told apart at all
  double named_share = 0.15;  ///< of the largest part in a combination, for a name to be said
  double least_told = 0.25;   ///< of the noise that a named number's typical change must show at least: one that shows
                              ///< less wanders; geometry must show all of it
  double noise = 1;         ///< what a number's typical change must show at least: sigma of a whitened residual, above
                            ///< 1 where the model is known to be off
  bool twins_stay = false;  ///< named numbers stay wherever they show at all, also in what others do as well
  std::vector<int> at_bound;  ///< numbers that can move one way only: what others can do as well is not theirs
  Eigen::VectorXd offset;  ///< of each variable from its start, where the state is not the start: a number that could
                           ///< not go back unseen (95 %) is told although its typical change would not show
};

/// An unknown that is held at its start, and why.
struct HeldUnknown {
  int unknown = -1;
  bool is_seen = false;        ///< the readings depend on it, but only in combination
  std::vector<int> with;       ///< the unknowns it cannot be told from, the strongest first
  std::vector<double> shares;  ///< how much of each (variables over their typical sizes) does what one of it does
};

struct Identifiability {
  std::vector<int> kept;  ///< in the order of the unknowns
  std::vector<HeldUnknown> held;
  Eigen::VectorXd singular_values;  ///< of the kept columns, each over its typical size, largest first
};

/// Takes the columns of a whitened Jacobian one by one: placings, then named numbers in their order, then geometry by
/// the largest part of its own (a pivoted QR). A column stays while what is its own, moved by its typical size or back
/// to its start, is longer than the noise and more than rounding.
[[nodiscard]] Identifiability findIdentifiable(const Eigen::MatrixXd& jacobian, const std::vector<Unknown>& unknowns,
                                               const IdentifiabilityOptions& options = {});

}  // namespace tubeplan::calibration
