// Times as clocks write them.
#pragma once

#include <optional>
#include <string_view>

namespace tubeplan::app {

/// Seconds of "2026-11-01 10:00:00.123", of the same with a T between, or of "10:00:00" since midnight; nothing for any
/// other text. Only differences mean anything: zones and leap seconds are not known.
[[nodiscard]] std::optional<double> clockSeconds(std::string_view text);

}  // namespace tubeplan::app
