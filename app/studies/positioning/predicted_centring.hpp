// Predicted centring error of the identified arm at the holes of its cell's sheet, from the uncertainty that the
// readings leave.
#pragma once

#include <string>

#include "app/studies/cell_model.hpp"
#include "calibration/forecast/centring_forecast.hpp"

namespace tubeplan::app {

struct PredictedCentring {
  std::string reason;  ///< reason if there is none; else empty
  calibration::CentringForecast forecast;
  int holes = 0;         ///< number that the arm reaches
  int out_of_reach = 0;  ///< number that it does not reach
  int on_sheet = 0;
  std::string worst_hole;
  bool later_stage = false;  ///< true: numbers found in earlier stages count as exact
};

/// Predicts the error under holes spread over the sheet (all of a small one), in the first posture that reaches each;
/// links are not checked for collisions. `is_staged`: the fit is the last of several stages. The result is unusable
/// once `stop` has returned true.
[[nodiscard]] PredictedCentring predictCentring(const CellModel& cell, const calibration::Identification& fit,
                                                bool is_staged, const calibration::StopQuestion& stop = {});

}  // namespace tubeplan::app
