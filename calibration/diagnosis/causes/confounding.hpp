// Causes that these measurements can hardly distinguish: after projection orthogonal to the fitted parameters'
// Jacobian, the signature of one cause lies in the span of another cause's signature.
#pragma once

#include <string>
#include <vector>

#include "calibration/diagnosis/causes/cause.hpp"

namespace tubeplan::calibration {

struct ConfoundedCause {
  std::string effect, at;
  /// Fraction of the confounded signature's squared length that this cause can reproduce, in the worst direction.
  double share = 0;
};

struct Confounding {
  std::string effect, at;
  /// Fraction of the signature's length that the fitted parameters do not absorb.
  double kept = 0;
  /// Confounded causes, largest shared fraction first; empty if the fitted parameters absorb almost the whole
  /// signature.
  std::vector<ConfoundedCause> confounded;
};

/// Smallest shared fraction at which one cause is reported as confounded with another.
inline constexpr double kConfoundedShare = 0.98;
inline constexpr double kHardlyKept = 1e-3;

/// Finds, for every cause that the measurements could reveal, the causes with which it is confounded. The model is
/// linearised at `placed` with respect to the unknowns `fitted`; each scanned parameter takes the middle one of its
/// levels. Returns an empty list if the model cannot be evaluated.
[[nodiscard]] std::vector<Confounding> findConfounding(const PlacedArm& placed,
                                                       const std::vector<Measurement>& measurements,
                                                       const std::vector<Unknown>& fitted);

}  // namespace tubeplan::calibration
