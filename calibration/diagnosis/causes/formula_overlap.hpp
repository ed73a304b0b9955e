// How much of a user's formula could as well be an effect of the catalogue: the share of its signature on the readings,
// the other fitted numbers projected off, that lies in the span of the effect's.
#pragma once

#include <string>
#include <vector>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

struct EffectShare {
  std::string effect, at;
  double share = 0;  ///< of the squared length of the formula's projected signature
};

struct FormulaOverlap {
  std::string formula;              ///< "formula@theta3"
  double absorbed = 0;              ///< share that the other fitted numbers can do
  std::vector<EffectShare> shares;  ///< of what is left; the largest first, effects that hardly share anything left out
};

/// Of every formula that the fitted arm carries, at the readings that were fitted. Empty where the identification is
/// not done or the model cannot be evaluated.
[[nodiscard]] std::vector<FormulaOverlap> findFormulaOverlaps(const Identification& result,
                                                              const std::vector<Measurement>& readings);

}  // namespace tubeplan::calibration
