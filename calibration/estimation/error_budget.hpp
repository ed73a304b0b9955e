// Division of a model's error into an explained part, a residual and noise. This is the only error stated in a
// document.
//
// The error is the root mean square, over the readings in use, of the length of measured minus predicted (ErrorSize).
// Held-out errors come from fits without the judged readings, fitted errors from fits with them. Readings that are set
// aside enter no result.
#pragma once

#include <vector>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

/// Parts of an error [m]. The signed squares add up: total = explained + remainder + noise.
struct ErrorBudget {
  double total = kNotKnown;      ///< error before the explanation is applied
  double explained = kNotKnown;  ///< part removed by the explanation; negative where the error rose
  double remainder = kNotKnown;  ///< residual error beyond the noise
  double noise = kNotKnown;      ///< noise floor, at most the error after the explanation
  int readings = 0;
  bool is_held_out = false;
  bool are_angles = false;  ///< true: all readings measure only angles
};

/// Errors of a model without and with an explanation, on the same readings.
struct ErrorsBeforeAndAfter {
  ErrorSize before, after;
};

/// Returns the budget of the held-out errors if both are known, otherwise that of the fitted errors.
[[nodiscard]] ErrorBudget errorBudget(const ErrorsBeforeAndAfter& held_out, const ErrorsBeforeAndAfter& fitted,
                                      double noise_floor);

/// Returns true if there are readings and all of them measure only angles.
[[nodiscard]] bool measureAnglesAlone(const std::vector<Measurement>& readings);

}  // namespace tubeplan::calibration
