// Suggestions ("did you mean ...?") for mistyped words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tubeplan::app {

/// Returns a text such as "did you mean 'limits'?" with the candidate most similar to the word; empty if none is
/// similar enough.
[[nodiscard]] std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

/// Returns the words as an enumeration such as "a, b or c".
[[nodiscard]] std::string alternatives(const std::vector<std::string>& words);

}  // namespace tubeplan::app
