// Where pieces of YAML text end: which the parser does not report.
#pragma once

#include <string_view>

namespace tubeplan::app {

/// Whether the sign at `at` is a # that starts a comment (outside quotes, which is for the caller to know).
[[nodiscard]] bool startsComment(std::string_view text, std::size_t at);

/// Past the closing quote that answers the one at `at`; npos where there is none.
[[nodiscard]] std::size_t pastQuoted(std::string_view text, std::size_t at);

/// Past the bracket or brace that answers the one at `at`.
[[nodiscard]] std::size_t pastFlow(std::string_view text, std::size_t at);

}  // namespace tubeplan::app
