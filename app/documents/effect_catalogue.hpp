// The effects that a cell's arm can have, as JSON and in words.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/cell/cell_reader.hpp"

namespace tubeplan::app {

/// Every effect at every place of the arm, with its words, law and numbers.
[[nodiscard]] nlohmann::json catalogueJson(const Cell& cell);

/// The same, a paragraph for each kind: words, law, numbers with their units and largest usual sizes, places. Of the
/// kind `only`, where it is not empty.
[[nodiscard]] std::string catalogueText(const Cell& cell, const std::string& only);

}  // namespace tubeplan::app
