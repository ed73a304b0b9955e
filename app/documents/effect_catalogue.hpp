// Catalogue of the effects that a cell's arm can have, as JSON and as text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/cell/cell_reader.hpp"

namespace tubeplan::app {

/// Returns every effect at every place of the arm, with its description, law and parameters.
[[nodiscard]] nlohmann::json catalogueJson(const Cell& cell);

/// Returns the catalogue as text with a paragraph for each kind of effect: description, law, parameters with units and
/// largest usual magnitudes, and places. `only` names the one kind to list; if it is empty, all kinds are listed.
[[nodiscard]] std::string catalogueText(const Cell& cell, const std::string& only);

}  // namespace tubeplan::app
