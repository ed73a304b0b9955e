// Causes that these readings can hardly distinguish: the signature of one, projected off the fitted numbers, lies in
// the span of another's.
#pragma once

#include <string>
#include <vector>

#include "calibration/diagnosis/causes/cause.hpp"

namespace tubeplan::calibration {

struct ConfoundedCause {
  std::string effect, at;
  double share = 0;  ///< shared part of the signature's squared length, in the direction with the smallest share
};

struct Confounding {
  std::string effect, at;
  double kept = 0;  ///< share of the signature's length that the fitted numbers cannot absorb
  /// Confounded causes, nearest first; none if hardly any of the signature is kept.
  std::vector<ConfoundedCause> confounded;
};

inline constexpr double kConfoundedShare = 0.98;  ///< least share of a cause that counts as confounded with another
inline constexpr double kHardlyKept = 1e-3;

/// Finds the confounded causes of every cause that the readings could show, linearised at the placed model with the
/// fitted unknowns `fitted`. Shapes are at the middle of their levels. Returns an empty list if the model cannot be
/// evaluated.
[[nodiscard]] std::vector<Confounding> findConfounding(const PlacedArm& placed,
                                                       const std::vector<Measurement>& readings,
                                                       const std::vector<Unknown>& fitted);

}  // namespace tubeplan::calibration
