// What a request's JSON body says, taken out value by value, so that nothing that a browser sends is trusted; postures,
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

/// The object in the body; an empty body is an empty object. Throws NotJson for text that is none, no object or
/// nested deeper than kDeepestJson.
[[nodiscard]] nlohmann::json objectOf(const Request& request);

/// Each gives `otherwise` where the key is missing or null, and throws InputError naming the key for a value of another
/// kind or out of its bounds.
[[nodiscard]] int integerOf(const nlohmann::json& object, const std::string& key, int otherwise, int least, int most);
[[nodiscard]] std::uint64_t seedOf(const nlohmann::json& object);
[[nodiscard]] double numberOf(const nlohmann::json& object, const std::string& key, double otherwise);
[[nodiscard]] bool booleanOf(const nlohmann::json& object, const std::string& key, bool otherwise);
[[nodiscard]] std::string textOf(const nlohmann::json& object, const std::string& key,
                                 const std::string& otherwise = "");
[[nodiscard]] std::vector<std::string> textsOf(const nlohmann::json& object, const std::string& key);

/// Finite numbers; throws InputError for anything else, and where there are none.
[[nodiscard]] std::vector<double> numbersOf(const nlohmann::json& object, const std::string& key);

/// A key that must be there. Throws InputError.
[[nodiscard]] const nlohmann::json& requiredOf(const nlohmann::json& object, const std::string& key,
                                               const std::string& expected);

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
