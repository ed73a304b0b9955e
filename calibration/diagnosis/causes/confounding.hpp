// Causes that these readings can hardly distinguish: after projection orthogonal to the fitted parameters' Jacobian,
// the signature of one cause lies in the span of another cause's signature.
#pragma once

#include <string>
#include <vector>

#include "calibration/diagnosis/causes/cause.hpp"

namespace tubeplan::calibration {

struct ConfoundedCause {
  std::string effect, at;
  /// Fraction of the squared length of the confounded signature that this cause's signature reproduces, in the
  /// direction that it reproduces worst.
  double share = 0;
};

struct Confounding {
  std::string effect, at;
  double kept = 0;  ///< fraction of the signature's length that the fitted parameters cannot absorb
  /// Confounded causes, largest shared fraction first; empty if hardly any of the signature is kept.
  std::vector<ConfoundedCause> confounded;
};

/// Smallest shared fraction at which a cause counts as confounded with another.
inline constexpr double kConfoundedShare = 0.98;
inline constexpr double kHardlyKept = 1e-3;

/// Finds, for every cause that the readings could show, the causes with which it is confounded. The model is linearised
/// at `placed` with respect to the unknowns `fitted`; each scanned parameter is at the middle one of its levels.
/// Returns an empty list if the model cannot be evaluated.
[[nodiscard]] std::vector<Confounding> findConfounding(const PlacedArm& placed,
                                                       const std::vector<Measurement>& readings,
                                                       const std::vector<Unknown>& fitted);

}  // namespace tubeplan::calibration
