// "did you mean ...?" for words a user mistyped.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tubeplan::app {

/// "did you mean 'limits'?" where one of the candidates is near enough to the word, else empty.
[[nodiscard]] std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

/// "a, b or c".
[[nodiscard]] std::string alternatives(const std::vector<std::string>& words);

}  // namespace tubeplan::app
