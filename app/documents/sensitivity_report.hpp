// Sensitivity analysis as JSON and as two rankings for people.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/design/sensitivity.hpp"

namespace tubeplan::app {

/// Sensitivity analysis with its assumptions.
struct SensitivityReport {
  calibration::Sensitivity figures;
  int work = 0, work_lost = 0;       ///< number of postures; number of the list's tubes that are out of reach
  bool has_sheet = false;            ///< if false, errors are total, not across the holes
  std::vector<std::string> touches;  ///< holes that place the base, or names of postures; empty: the base is known
  std::vector<double>
      sigmas;  ///< sigma of each number [its unit], NaN if no reading determines it; empty without readings
};

[[nodiscard]] nlohmann::json sensitivityJson(const SensitivityReport& report, const Cell& cell);

/// Returns in words, from its JSON, the numbers worth changing and those that must be known.
[[nodiscard]] std::string sensitivityText(nlohmann::json figures);

}  // namespace tubeplan::app
