// Units of the values in a JSON document, derived from their keys.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

namespace tubeplan::app {

/// Returns the unit of the value at a path of keys such as "rms/after"; empty for a dimensionless number. `scopes`
/// holds the document first, then the nested objects that contain the value, outermost first.
[[nodiscard]] std::string figureUnit(std::string_view path, std::span<const nlohmann::json* const> scopes);

}  // namespace tubeplan::app
