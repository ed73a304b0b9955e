// Division of a model's error into an explained part, a remainder and noise: the one error of a document.
//
// The error is the root mean square, over the readings in use, of the length of measured less predicted (ErrorSize):
// held out if the readings were judged by fits without them, else fitted. Readings that are set aside are
// in no figure.
#pragma once

#include <vector>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

/// Parts of an error [m]. In squares: total = explained + remainder + noise, each with its sign.
struct ErrorBudget {
  double total = kNotKnown;      ///< before what explains
  double explained = kNotKnown;  ///< taken away by it; below zero where the error rose
  double remainder = kNotKnown;  ///< left beyond the noise
  double noise = kNotKnown;      ///< the noise floor, as far as the error reaches it
  int readings = 0;
  bool is_held_out = false;
  bool are_angles = false;  ///< true: all readings measure angles alone
};

/// The errors of a model without and with an explanation, on the same readings.
struct ErrorsBeforeAndAfter {
  ErrorSize before, after;
};

/// Returns the budget of the held-out errors if both are known, else that of the fitted ones.
[[nodiscard]] ErrorBudget errorBudget(const ErrorsBeforeAndAfter& held_out, const ErrorsBeforeAndAfter& fitted,
                                      double noise_floor);

/// Returns true if there are readings and all of them measure angles alone.
[[nodiscard]] bool measureAnglesAlone(const std::vector<Measurement>& readings);

}  // namespace tubeplan::calibration
