// Ends of pieces of YAML text, which the parser does not report.
#pragma once

#include <string_view>

namespace tubeplan::app {

/// Returns true for a # at `at` that starts a comment, if it is outside quotes, which the caller must check.
[[nodiscard]] bool startsComment(std::string_view text, std::size_t at);

/// Returns the index after the closing quote for the one at `at`; npos if there is none.
[[nodiscard]] std::size_t pastQuoted(std::string_view text, std::size_t at);

/// Returns the index after the closing bracket or brace for the one at `at`.
[[nodiscard]] std::size_t pastFlow(std::string_view text, std::size_t at);

}  // namespace tubeplan::app
