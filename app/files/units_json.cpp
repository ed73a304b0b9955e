#include "app/files/units_json.hpp"

#include <nlohmann/json.hpp>

namespace tubeplan::app {

nlohmann::json unitsJson(const Units& units) {
  return {{"length", units.length().name},
          {"angle", units.angle().name},
          {"force", units.force().name},
          {"temperature", units.temperature().name},
          {"time", units.time().name}};
}

}  // namespace tubeplan::app
