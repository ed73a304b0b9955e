// Sensitivity analysis, as JSON and as text with two rankings.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/design/sensitivity.hpp"

namespace tubeplan::app {

/// Results of a sensitivity analysis, with its assumptions.
struct SensitivityReport {
  calibration::Sensitivity figures;
  int work = 0, work_lost = 0;  ///< number of work postures, and of listed tubes out of reach
  bool has_sheet = false;       ///< true if errors are measured in the plane of the sheet; false if in all directions
  /// Holes, or names of postures, whose touches determine the base; empty means that the base is known.
  std::vector<std::string> touches;
  /// Standard deviation of each parameter, in internal units; NaN if no measurement determines it; empty without
  /// measurements.
  std::vector<double> sigmas;
};

[[nodiscard]] nlohmann::json sensitivityJson(const SensitivityReport& report, const Cell& cell);

/// Returns, from the JSON of the analysis, a text with two rankings: the parameters whose change reduces the error
/// most, and those that must be known accurately.
[[nodiscard]] std::string sensitivityText(nlohmann::json figures);

}  // namespace tubeplan::app
