// Values in the JSON body of a request, each checked when it is read, because input from a browser is not trusted.
// Postures and loads are in the cell's units; holes are tube indices.
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

/// Returns the JSON object in the body; an empty body is an empty object. Throws NotJson for text that is not JSON, for
/// a value that is not an object, and for nesting deeper than kDeepestJson.
[[nodiscard]] nlohmann::json objectOf(const Request& request);

/// Returns the value of a key, or `otherwise` if the key is missing or null. Throws InputError, which names the key,
/// for a value of the wrong type or out of range. The same applies to the five functions below.
[[nodiscard]] int integerOf(const nlohmann::json& object, const std::string& key, int otherwise, int least, int most);
[[nodiscard]] std::uint64_t seedOf(const nlohmann::json& object);
[[nodiscard]] double numberOf(const nlohmann::json& object, const std::string& key, double otherwise);
[[nodiscard]] bool booleanOf(const nlohmann::json& object, const std::string& key, bool otherwise);
[[nodiscard]] std::string textOf(const nlohmann::json& object, const std::string& key,
                                 const std::string& otherwise = "");
[[nodiscard]] std::vector<std::string> textsOf(const nlohmann::json& object, const std::string& key);

/// Returns a list of finite numbers. Throws InputError for any other value, and for an empty list.
[[nodiscard]] std::vector<double> numbersOf(const nlohmann::json& object, const std::string& key);

/// Returns the value of a required key. Throws InputError, which names the `expected` value, if the key is missing.
[[nodiscard]] const nlohmann::json& requiredOf(const nlohmann::json& object, const std::string& key,
                                               const std::string& expected);

/// Returns the value of "joints": one number for each active joint, in internal units. Throws InputError for a wrong
/// number of joints, and for a value that is not finite or exceeds the joint's limits.
[[nodiscard]] Eigen::VectorXd jointsOf(const nlohmann::json& body, const Cell& cell);

/// Returns the value of "load" [N]; 0 if the key is missing.
[[nodiscard]] double loadOf(const nlohmann::json& body, const Cell& cell);

/// Returns the value of "hole", a tube index in the sheet; nullopt if the key is missing.
[[nodiscard]] std::optional<int> holeOf(const nlohmann::json& body, const Cell& cell);

/// Returns the value of "hole", a tube index in the sheet. Throws InputError if the key is missing.
[[nodiscard]] int requiredHoleOf(const nlohmann::json& body, const Cell& cell);

/// Returns the indices of the tubes that a selection such as "R10C20,outer:2" selects; opens no file. Throws
/// InputError.
[[nodiscard]] std::vector<int> selectedTubes(const std::string& text, const tubesheets::Sheet& sheet);

/// Returns the value of "tubes", which is a selection or a list of tube indices, as a selection. Returns `otherwise` if
/// the key is missing.
[[nodiscard]] std::string tubesText(const nlohmann::json& body, const tubesheets::Sheet& sheet,
                                    const std::string& otherwise);

/// Returns the value of "stays": dwell times from 0 to a day [s], keyed by tube index; empty if the key is missing.
/// Throws InputError.
[[nodiscard]] std::map<int, double> dwellTimesOf(const nlohmann::json& body, const tubesheets::Sheet& sheet);

}  // namespace tubeplan::app
