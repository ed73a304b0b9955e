// UTF-8 text: checks and printable forms.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tubeplan::app {

/// Returns the length in bytes of the well-formed sequence that starts at `at` (Unicode 15, table 3-7); 0 if there is
/// none.
[[nodiscard]] std::size_t sequenceLength(std::string_view text, std::size_t at);

/// Returns true for a control character: C0 (line ends and tabs too), DEL or C1.
[[nodiscard]] bool isControl(std::string_view sequence);

/// Returns true if a text is UTF-8 without control characters other than line ends (LF, CR LF) and tabs.
[[nodiscard]] bool isPlainText(std::string_view text);

/// Returns the index of the first byte that is not allowed in text; nothing if there is none.
[[nodiscard]] std::optional<std::size_t> findNonText(std::string_view text);

/// Returns the text as one printable line. Control characters (line ends too), marks that change the direction of
/// writing and bytes that are not UTF-8 appear as escapes. Cut after `longest` bytes.
[[nodiscard]] std::string printable(std::string_view text, std::size_t longest);

}  // namespace tubeplan::app
