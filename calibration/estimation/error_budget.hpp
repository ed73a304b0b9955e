// How the error of a model divides into what is explained, what remains and noise: the one error of a document.
//
// The error is the root mean square, over the readings in use, of the length of measured less predicted (ErrorSize):
// held out where the readings were judged by fits that had not seen them, else fitted. Readings that are set aside are
// in no figure.
#pragma once

#include <limits>
#include <vector>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

/// In squares: total = explained + remainder + noise, each share with its sign. [m]
struct ErrorBudget {
  double total = std::numeric_limits<double>::quiet_NaN();      ///< before what explains
  double explained = std::numeric_limits<double>::quiet_NaN();  ///< taken away by it; below zero where the error rose
  double remainder = std::numeric_limits<double>::quiet_NaN();  ///< left beyond the noise
  double noise = std::numeric_limits<double>::quiet_NaN();      ///< the noise floor, as far as the error reaches it
  int readings = 0;
  bool is_held_out = false;
  bool are_angles = false;  ///< as ErrorSize has it
};

/// The errors of a model without and with what explains, on the same readings.
struct ErrorsBeforeAndAfter {
  ErrorSize before, after;
};

/// Returns the budget of the held-out errors where both are known, else that of the fitted ones.
[[nodiscard]] ErrorBudget errorBudget(const ErrorsBeforeAndAfter& held_out, const ErrorsBeforeAndAfter& fitted,
                                      double noise_floor);

/// Returns whether the readings measure nothing but angles; false of none.
[[nodiscard]] bool measureAnglesAlone(const std::vector<Measurement>& readings);

}  // namespace tubeplan::calibration
