// Times as clocks write them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tubeplan::app {

/// Seconds of "2026-11-01 10:00:00.123", of the same with a T between, or of "10:00:00" since midnight; nothing for any
/// other text. Only differences mean anything: zones and leap seconds are not known.
[[nodiscard]] std::optional<double> clockSeconds(std::string_view text);

/// Times of rows that follow one another.
struct ClockTimes {
  std::vector<std::optional<double>> seconds;  ///< of each row, as clockSeconds() gives them, days added
  std::vector<std::size_t> midnights;          ///< rows from which a day more is added
};

/// A clock without a date that goes back by half a day or more has passed midnight.
[[nodiscard]] ClockTimes clockTimes(const std::vector<std::string>& rows);

}  // namespace tubeplan::app
