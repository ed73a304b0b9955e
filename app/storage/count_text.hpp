// Counts with their noun.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace tubeplan::app {

/// Returns a count with its noun in the singular or with an s: "1 reading", "3 readings".
[[nodiscard]] inline std::string countText(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace tubeplan::app
