// Division of a model's error into an explained part, a remainder and noise: the one error of a document.
//
// The error is the root mean square, over the readings in use, of the length of measured less predicted (ErrorSize):
// held out if the readings were judged by fits without them, else fitted. Readings that are set aside are
// in no figure.
#pragma once

#include <limits>
#include <vector>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

/// Parts of an error [m]. In squares: total = explained + remainder + noise, each with its sign.
struct ErrorBudget {
  double total = std::numeric_limits<double>::quiet_NaN();  ///< error before the explanation
  /// Part removed by the explanation; negative if the error rose.
  double explained = std::numeric_limits<double>::quiet_NaN();
  double remainder = std::numeric_limits<double>::quiet_NaN();  ///< part left beyond the noise
  double noise = std::numeric_limits<double>::quiet_NaN();      ///< the noise floor, limited to the error
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
