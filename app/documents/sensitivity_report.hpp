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
  int work = 0, work_lost = 0;  ///< number of work postures; number of listed tubes out of reach
  bool has_sheet = false;       ///< true: errors are across the holes; false: errors are total
  /// Holes, or names of postures, whose touches determine the base; empty: the base is known.
  std::vector<std::string> touches;
  /// Standard deviation of each parameter, in the parameter's unit; NaN: no reading determines it; empty: no readings.
  std::vector<double> sigmas;
};

[[nodiscard]] nlohmann::json sensitivityJson(const SensitivityReport& report, const Cell& cell);

/// Returns a text, from the JSON of the analysis, that ranks the parameters worth changing and the parameters that must
/// be known.
[[nodiscard]] std::string sensitivityText(nlohmann::json figures);

}  // namespace tubeplan::app
