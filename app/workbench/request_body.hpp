// What a request's JSON body says, taken out value by value, so that nothing that a browser sends is trusted.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

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

}  // namespace tubeplan::app
