// Catalogue of the effects that a cell's arm can have, as JSON and in words.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/cell/cell_reader.hpp"

namespace tubeplan::app {

/// Returns every effect at every place of the arm, with its words, law and numbers.
[[nodiscard]] nlohmann::json catalogueJson(const Cell& cell);

/// Returns the catalogue with a paragraph for each kind: words, law, numbers with their units and largest usual sizes,
/// places. Restricted to the kind `only` unless that is empty.
[[nodiscard]] std::string catalogueText(const Cell& cell, const std::string& only);

}  // namespace tubeplan::app
