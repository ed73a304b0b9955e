// Division of a model's error into an explained part, an unexplained remainder and noise. All documents state model
// errors in this form.
//
// The error is the root mean square of the distances between measured and predicted values (ErrorSize). A held-out
// error is computed over measurements that the fit has not used, a fitted error over those that it has used.
// Measurements set aside as outliers are not counted.
#pragma once

#include <vector>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

/// Parts of a model's error [m], such that total^2 = explained |explained| + remainder^2 + noise^2.
struct ErrorBudget {
  double total = kNotKnown;      ///< error of the model without the explanation
  double explained = kNotKnown;  ///< part that the explanation removes; negative if it increases the error
  double remainder = kNotKnown;  ///< remaining error that noise does not account for
  double noise = kNotKnown;      ///< noise floor, but no more than the error with the explanation
  int measurements = 0;
  bool is_held_out = false;
  bool are_angles = false;  ///< true if all measurements measure only angles
};

/// Errors of a model on the same measurements, before and after an explanation (such as a fitted effect) is added.
struct ErrorsBeforeAndAfter {
  ErrorSize before, after;
};

/// Returns the error budget from the held-out errors if both of them are known, otherwise from the fitted errors.
[[nodiscard]] ErrorBudget errorBudget(const ErrorsBeforeAndAfter& held_out, const ErrorsBeforeAndAfter& fitted,
                                      double noise_floor);

/// Returns true if there are measurements and all of them measure only angles.
[[nodiscard]] bool measureOnlyAngles(const std::vector<Measurement>& measurements);

}  // namespace tubeplan::calibration
