// Which causes these readings can hardly distinguish: the signature of the one, what the fitted numbers can
// do projected off, lies in the span of the other's.
#pragma once

#include <string>
#include <vector>

#include "calibration/diagnosis/causes/cause.hpp"

namespace tubeplan::calibration {

struct ConfoundedCause {
  std::string effect, at;
  double share = 0;  ///< of the squared length of the signature, in the direction that shares least
};

struct Confounding {
  std::string effect, at;
  double kept = 0;                          ///< share of the signature's length that the fitted numbers cannot do
  std::vector<ConfoundedCause> confounded;  ///< the nearest first; none for a cause of which hardly anything is kept
};

inline constexpr double kConfoundedShare = 0.98;  ///< from which a cause counts as confounded with another
inline constexpr double kHardlyKept = 1e-3;

/// Of every cause that the readings could show, about the model as it is placed; `fitted` are the numbers fitted with
/// it. Shapes at the middle of their levels. Empty where the model cannot be evaluated.
[[nodiscard]] std::vector<Confounding> findConfounding(const PlacedArm& placed,
                                                       const std::vector<Measurement>& readings,
                                                       const std::vector<Unknown>& fitted);

}  // namespace tubeplan::calibration
