// The units of a document's figures, by their keys.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

namespace tubeplan::app {

/// Of the number at this path of keys, "rms/after"; empty of a pure number. `scopes`: the document first, then what
/// leads to the figure.
[[nodiscard]] std::string figureUnit(std::string_view path, std::span<const nlohmann::json* const> scopes);

}  // namespace tubeplan::app
