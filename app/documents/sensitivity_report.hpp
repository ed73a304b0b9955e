// A sensitivity analysis as JSON and as two rankings for people.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/design/sensitivity.hpp"

namespace tubeplan::app {

/// The analysis with what it stands on.
struct SensitivityReport {
  calibration::Sensitivity figures;
  int work = 0, work_lost = 0;       ///< postures; tubes of the list that are out of reach
  bool has_sheet = false;            ///< else errors are whole, not across the holes
  std::vector<std::string> touches;  ///< holes that place the base, or names of postures; empty: the base is known
  std::vector<double>
      sigmas;  ///< of each number [its unit], NaN where no reading determines it; empty without readings
};

[[nodiscard]] nlohmann::json sensitivityJson(const SensitivityReport& report, const Cell& cell);

/// In words, from its JSON: what to change, and what must be known.
[[nodiscard]] std::string sensitivityText(nlohmann::json figures);

}  // namespace tubeplan::app
