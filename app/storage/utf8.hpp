// Text as UTF-8: what is well formed, and what may be shown.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tubeplan::app {

/// Length in bytes of the well-formed sequence that starts at `at` (Unicode 15, table 3-7), 0 where there is none.
[[nodiscard]] std::size_t sequenceLength(std::string_view text, std::size_t at);

/// Whether it is a control character, C0 (line ends and tabulators too), DEL or C1.
[[nodiscard]] bool isControl(std::string_view sequence);

/// Returns whether a text is UTF-8 without control characters but line ends (LF, CR LF) and tabulators.
[[nodiscard]] bool isPlainText(std::string_view text);

/// Returns the place of the first byte that no text has; nothing where all is text.
[[nodiscard]] std::optional<std::size_t> findNonText(std::string_view text);

/// One line that shows what is in the text: control characters, line ends among them, marks that turn the direction of
/// writing and bytes that are no UTF-8 are written out. What comes after `longest` bytes is left out.
[[nodiscard]] std::string printable(std::string_view text, std::size_t longest);

}  // namespace tubeplan::app
