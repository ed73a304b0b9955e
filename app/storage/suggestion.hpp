// Suggestions ("did you mean ...?") for mistyped words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tubeplan::app {

/// Returns "did you mean 'limits'?" if one of the candidates is similar enough to the word, else empty.
[[nodiscard]] std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

/// Returns the words as "a, b or c".
[[nodiscard]] std::string alternatives(const std::vector<std::string>& words);

}  // namespace tubeplan::app
