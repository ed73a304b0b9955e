// Predicted centring error of the identified arm at the holes of its cell's sheet, caused by the parameter uncertainty
// that remains after the fit.
#pragma once

#include <string>

#include "app/studies/cell_model.hpp"
#include "calibration/forecast/centring_forecast.hpp"

namespace tubeplan::app {

struct PredictedCentring {
  std::string reason;  ///< reason why there is no prediction; empty on success
  calibration::CentringForecast forecast;
  int holes = 0;         ///< number of tried holes that the arm reaches
  int out_of_reach = 0;  ///< number of tried holes that the arm does not reach
  int on_sheet = 0;
  std::string worst_hole;
  bool later_stage = false;  ///< true if parameters found in earlier stages are treated as exact
};

/// Predicts the centring error under holes spread over the sheet (all holes of a small sheet), each in the first
/// posture that reaches the hole; links are not checked for collisions. `is_staged` is true if the fit is the last of
/// several stages. The result is invalid if `stop` has returned true.
[[nodiscard]] PredictedCentring predictCentring(const CellModel& cell, const calibration::Identification& fit,
                                                bool is_staged, const calibration::StopQuestion& stop = {});

}  // namespace tubeplan::app
