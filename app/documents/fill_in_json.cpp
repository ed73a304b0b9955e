#include "app/documents/fill_in_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace tubeplan::app {

nlohmann::json fillInJson(const FillIn& fill) {
  return {{"columns", fill.columns}, {"least", fill.least}, {"optional", fill.optional}};
}

std::string fillInText(const std::vector<calibration::ProposedMeasurement>& sheet, const deflection::Arm& arm,
                       const Units& units) {
  std::vector<std::string> columns;
  for (const auto& measurement : sheet)
    for (const auto& column : fillInOf(measurement, arm, units).columns)
      if (std::ranges::find(columns, column) == columns.end()) columns.push_back(column);
  return fmt::format("fill in {}", fmt::join(columns, ", "));
}

}  // namespace tubeplan::app
