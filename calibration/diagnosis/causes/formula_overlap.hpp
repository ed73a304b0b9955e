// Overlap of a user's formula with effects of the catalogue: the fraction of the formula's signature in the readings
// that lies in the span of an effect's signature, after projection orthogonal to the other fitted parameters' Jacobian.
#pragma once

#include <string>
#include <vector>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

struct EffectShare {
  std::string effect, at;
  double share = 0;  ///< fraction of the formula's projected signature, in squared length, that the effect shares
};

struct FormulaOverlap {
  std::string formula;  ///< formula with its place, such as "formula@theta3"
  double absorbed = 0;  ///< fraction of the signature, in squared length, that the other fitted parameters absorb
  /// Effects that share the projected signature, largest fraction first; small fractions left out.
  std::vector<EffectShare> shares;
};

/// Computes the overlaps of every formula of the fitted arm at the fitted readings. Returns an empty list if the
/// identification is not completed or the model cannot be evaluated.
[[nodiscard]] std::vector<FormulaOverlap> findFormulaOverlaps(const Identification& result,
                                                              const std::vector<Measurement>& readings);

}  // namespace tubeplan::calibration
