// Division of a model's error into an explained part, an unexplained remainder and noise. Documents state a model's
// error in this form only.
//
// The error is the root mean square, over the readings in use, of the length of measured minus predicted (ErrorSize).
// Held-out errors come from fits without the judged readings, fitted errors from fits with them. Readings that are set
// aside as outliers are not counted.
#pragma once

#include <vector>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

/// Parts of an error [m]. Their squares add up, with the sign of each part: total^2 = explained |explained| +
/// remainder^2 + noise^2.
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
