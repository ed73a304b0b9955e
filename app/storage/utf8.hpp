// UTF-8 text: checks and printable forms.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tubeplan::app {

/// Returns the length in bytes of the well-formed UTF-8 sequence that starts at index `at` (Unicode 15, table 3-7); 0
/// if there is none.
[[nodiscard]] std::size_t sequenceLength(std::string_view text, std::size_t at);

/// Returns true if the UTF-8 sequence is a control character: C0 (including line ends and tabs), DEL or C1.
[[nodiscard]] bool isControl(std::string_view sequence);

/// Returns true if the text is UTF-8 without control characters other than line ends (LF, CR LF) and tabs.
[[nodiscard]] bool isPlainText(std::string_view text);

/// Returns the index of the first byte that isPlainText() does not allow; std::nullopt if there is none.
[[nodiscard]] std::optional<std::size_t> findNonText(std::string_view text);

/// Returns the text as one printable line. Control characters (including line ends), marks that change the writing
/// direction and bytes that are not UTF-8 become escapes. Text beyond `longest` bytes is replaced by "...".
[[nodiscard]] std::string printable(std::string_view text, std::size_t longest);

}  // namespace tubeplan::app
