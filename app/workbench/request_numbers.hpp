// Postures, loads and holes that a request names, in the cell's units.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/files/cell_reader.hpp"

namespace tubeplan::app {

/// "joints": one reading for each active joint. Internal units. Throws InputError for another count, for what is no
/// finite number and past a joint's limits.
[[nodiscard]] Eigen::VectorXd jointsOf(const nlohmann::json& body, const Cell& cell);

/// "load", 0 where it is missing [N].
[[nodiscard]] double loadOf(const nlohmann::json& body, const Cell& cell);

/// "hole": an index in the sheet, where it is there.
[[nodiscard]] std::optional<int> holeOf(const nlohmann::json& body, const Cell& cell);

/// The same where there must be one.
[[nodiscard]] int requiredHoleOf(const nlohmann::json& body, const Cell& cell);

/// The tubes of a text in the selection language; no file is opened. Throws InputError.
[[nodiscard]] std::vector<int> selectedTubes(const std::string& text, const tubesheets::Sheet& sheet);

/// "tubes": a text, or a list of indices; `otherwise` where it is missing. The text that selects them.
[[nodiscard]] std::string tubesText(const nlohmann::json& body, const tubesheets::Sheet& sheet,
                                    const std::string& otherwise);

/// "stays": {index: seconds} of tubes, from 0 to a day; none where it is missing. Throws InputError.
[[nodiscard]] std::map<int, double> staysOf(const nlohmann::json& body, const tubesheets::Sheet& sheet);

}  // namespace tubeplan::app
