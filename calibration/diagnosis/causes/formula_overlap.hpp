// Overlap of a user's formula with effects of the catalogue: the share of the formula's signature on the readings that
// lies in the span of an effect's, after projection off the other fitted numbers.
#pragma once

#include <string>
#include <vector>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

struct EffectShare {
  std::string effect, at;
  double share = 0;  ///< shared part of the squared length of the formula's projected signature
};

struct FormulaOverlap {
  std::string formula;              ///< "formula@theta3"
  double absorbed = 0;              ///< share that the other fitted numbers absorb
  std::vector<EffectShare> shares;  ///< shares of the projected signature, largest first; small ones left out
};

/// Finds the overlaps of every formula of the fitted arm at the fitted readings. Returns an empty list if the
/// identification is not done or the model cannot be evaluated.
[[nodiscard]] std::vector<FormulaOverlap> findFormulaOverlaps(const Identification& result,
                                                              const std::vector<Measurement>& readings);

}  // namespace tubeplan::calibration
