// How far the identified arm may miss the holes of its cell's sheet, by what the readings leave open.
#pragma once

#include <string>

#include "app/studies/cell_model.hpp"
#include "calibration/forecast/centring_forecast.hpp"

namespace tubeplan::app {

struct PredictedCentring {
  std::string reason;  ///< why there is none; empty where there is one
  calibration::CentringForecast forecast;
  int holes = 0;         ///< looked at: those that the arm reaches
  int out_of_reach = 0;  ///< of those looked for
  int on_sheet = 0;
  std::string worst_hole;
  bool later_stage = false;  ///< numbers found in stages before count as exact
};

/// Under each of some holes spread over the sheet (all of a small one), in the first posture that reaches it; links are
/// not checked for collisions. `is_staged`: the fit is the last of several stages. Of no use once `stop` has said yes.
[[nodiscard]] PredictedCentring predictCentring(const CellModel& cell, const calibration::Identification& fit,
                                                bool is_staged, const calibration::StopQuestion& stop = {});

}  // namespace tubeplan::app
