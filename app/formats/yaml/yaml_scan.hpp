// Search for the ends of scalars and collections in YAML text, which yaml-cpp does not report.
#pragma once

#include <string_view>

namespace tubeplan::app {

/// Returns true if the # at index `at` starts a comment. The caller must ensure that `at` is outside quotes.
[[nodiscard]] bool startsComment(std::string_view text, std::size_t at);

/// Returns the index past the closing quote of a quoted scalar that begins at `at`; npos if there is no closing quote.
[[nodiscard]] std::size_t pastQuoted(std::string_view text, std::size_t at);

/// Returns the index past the closing bracket or brace of a flow collection that begins at `at`; the text's size if the
/// collection is not closed.
[[nodiscard]] std::size_t pastFlow(std::string_view text, std::size_t at);

}  // namespace tubeplan::app
