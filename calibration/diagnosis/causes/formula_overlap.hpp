// Overlap of a user's formula with effects of the catalogue: the fraction of the formula's signature (its first-order
// change of the measurements) that lies in the span of an effect's signature, after projection orthogonal to the other
// fitted parameters' Jacobian.
#pragma once

#include <string>
#include <vector>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

struct EffectShare {
  std::string effect, at;
  double share = 0;  ///< fraction of the squared length of the formula's projected signature that the effect reproduces
};

struct FormulaOverlap {
  std::string formula;  ///< formula with its place, such as "formula@theta3"
  double absorbed = 0;  ///< fraction of the signature's squared length that the other fitted parameters absorb
  /// Effects that reproduce more than 5 % of the projected signature, largest fraction first.
  std::vector<EffectShare> shares;
};

/// Computes, at the fitted measurements, the overlap of each formula of the fitted arm with the effects of the
/// catalogue. Returns an empty list if the identification was not completed or the model cannot be evaluated.
[[nodiscard]] std::vector<FormulaOverlap> findFormulaOverlaps(const Identification& result,
                                                              const std::vector<Measurement>& measurements);

}  // namespace tubeplan::calibration
