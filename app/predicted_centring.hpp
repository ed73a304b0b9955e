// How far the identified arm may miss the holes of its cell's sheet, by what the readings leave open.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/readers/cell_reader.hpp"
#include "calibration/centring_forecast.hpp"

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
[[nodiscard]] PredictedCentring predictCentring(const Cell& cell, const calibration::Identification& fit,
                                                bool is_staged, const calibration::StopQuestion& stop = {});

/// {median, p95, worst: {value, hole}, band: {median, p95, worst: [low, high]}, encoder_noise: {median, p95, worst},
/// unit, holes, ...}, or null with a reason.
[[nodiscard]] nlohmann::json predictedCentringJson(const PredictedCentring& predicted, const Units& units);

/// Empty for cells without a sheet.
[[nodiscard]] std::string predictedCentringText(const PredictedCentring& predicted, const Units& units);

}  // namespace tubeplan::app
