#include "app/documents/step_table_json.hpp"

#include <array>
#include <nlohmann/json.hpp>

namespace tubeplan::app {

nlohmann::json stepTableJson(const StepTable& table, const Units& units) {
  if (!table.reason.empty() || table.holes == 0) return nullptr;
  static constexpr std::array kNames{"zero", "one", "two", "three"};
  nlohmann::json json = {{"holes", table.holes}, {"counts", table.counts}, {"no_posture", table.no_posture}};
  json["centring_error"] = {{"median", lengthOf(table.median_error, units)}, {"p95", lengthOf(table.p95_error, units)}};
  for (std::size_t k = 0; k < kNames.size(); ++k) json[kNames[k]] = k < table.counts.size() ? table.counts[k] : 0;
  return json;
}

}  // namespace tubeplan::app
