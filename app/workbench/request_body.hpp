// Values of a request's JSON body, each checked as it is read, because a browser's input is not trusted; postures,
// loads and holes in the cell's units.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "app/workbench/exchange.hpp"

namespace tubeplan::app {

/// Returns the object in the body; an empty body is an empty object. Throws NotJson for text that is not JSON, no
/// object or nested deeper than kDeepestJson.
[[nodiscard]] nlohmann::json objectOf(const Request& request);

/// Return the value of a key, or `otherwise` if it is missing or null. Throw InputError naming the key for a value of
/// another kind or out of bounds.
[[nodiscard]] int integerOf(const nlohmann::json& object, const std::string& key, int otherwise, int least, int most);
[[nodiscard]] std::uint64_t seedOf(const nlohmann::json& object);
[[nodiscard]] double numberOf(const nlohmann::json& object, const std::string& key, double otherwise);
[[nodiscard]] bool booleanOf(const nlohmann::json& object, const std::string& key, bool otherwise);
[[nodiscard]] std::string textOf(const nlohmann::json& object, const std::string& key,
                                 const std::string& otherwise = "");
[[nodiscard]] std::vector<std::string> textsOf(const nlohmann::json& object, const std::string& key);

/// Returns finite numbers; throws InputError for anything else, and for an empty list.
[[nodiscard]] std::vector<double> numbersOf(const nlohmann::json& object, const std::string& key);

/// Returns the value of a required key. Throws InputError if it is missing.
[[nodiscard]] const nlohmann::json& requiredOf(const nlohmann::json& object, const std::string& key,
                                               const std::string& expected);

/// Returns "joints": one reading for each active joint, in internal units. Throws InputError for another count, for a
/// value that is no finite number or exceeds a joint's limits.
[[nodiscard]] Eigen::VectorXd jointsOf(const nlohmann::json& body, const Cell& cell);

/// Returns "load" [N], 0 if it is missing.
[[nodiscard]] double loadOf(const nlohmann::json& body, const Cell& cell);

/// Returns "hole", an index in the sheet, if it is given.
[[nodiscard]] std::optional<int> holeOf(const nlohmann::json& body, const Cell& cell);

/// Returns "hole", an index in the sheet. Throws InputError if it is missing.
[[nodiscard]] int requiredHoleOf(const nlohmann::json& body, const Cell& cell);

/// Returns the tubes of a text in the selection language; opens no file. Throws InputError.
[[nodiscard]] std::vector<int> selectedTubes(const std::string& text, const tubesheets::Sheet& sheet);

/// Returns the selection text of "tubes": a text, or a list of indices; `otherwise` if it is missing.
[[nodiscard]] std::string tubesText(const nlohmann::json& body, const tubesheets::Sheet& sheet,
                                    const std::string& otherwise);

/// Returns "stays": {index: seconds} of tubes, from 0 to a day; empty if it is missing. Throws InputError.
[[nodiscard]] std::map<int, double> staysOf(const nlohmann::json& body, const tubesheets::Sheet& sheet);

}  // namespace tubeplan::app
