// Suggestions ("did you mean ...?") for mistyped words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tubeplan::app {

/// Returns a question such as "did you mean 'limits'?" with the candidate most similar to the word; empty if none is
/// similar enough.
[[nodiscard]] std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

/// Returns suggestion(), or `otherwise` if no candidate is similar enough.
[[nodiscard]] std::string suggestionOr(std::string_view word, const std::vector<std::string>& candidates,
                                       const std::string& otherwise);

/// Returns the words as an enumeration such as "a, b or c".
[[nodiscard]] std::string alternatives(const std::vector<std::string>& words);

/// Returns the words as an enumeration such as "a, b and c".
[[nodiscard]] std::string enumeration(const std::vector<std::string>& words);

}  // namespace tubeplan::app
