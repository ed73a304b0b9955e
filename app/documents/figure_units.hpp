// Units of a document's figures, by their keys.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

namespace tubeplan::app {

/// Returns the unit of the number at this path of keys, "rms/after"; empty for a pure number. `scopes` holds the
/// document first, then the objects that lead to the figure.
[[nodiscard]] std::string figureUnit(std::string_view path, std::span<const nlohmann::json* const> scopes);

}  // namespace tubeplan::app
