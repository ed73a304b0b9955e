// Functions for mistakes that affect only some of the readings: one reading and all later ones, written
// "VALUE@READING", or a run of consecutive readings, written "FIRST..LAST".
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration {

/// Splits "VALUE@READING" into the value and the id of the first reading to which it applies; nullopt instead of the id
/// if the value applies to all readings.
[[nodiscard]] std::pair<std::string, std::optional<std::string>> partedAtReading(const std::string& value);

/// Returns `id` and the ids of all later readings; empty if there is no such reading.
[[nodiscard]] std::set<std::string> idsFrom(const std::vector<Measurement>& readings, const std::string& id);

/// Consecutive readings, given by the indices of the first and the last.
struct Run {
  std::size_t first = 0, last = 0;
};

/// Returns the run named by "FIRST..LAST"; nullopt if one of the two ids does not exist, or if LAST precedes FIRST.
[[nodiscard]] std::optional<Run> runNamed(const std::vector<Measurement>& readings, const std::string& text);

/// Returns the name "FIRST..LAST" of a run of readings.
[[nodiscard]] std::string textOf(const Run& run, const std::vector<Measurement>& readings);

[[nodiscard]] std::set<std::string> idsOf(const Run& run, const std::vector<Measurement>& readings);

/// Returns the ids that `text` names: `text` itself if it is the id of a reading, or the ids of all readings of the run
/// "FIRST..LAST"; empty if it is neither.
[[nodiscard]] std::set<std::string> idsNamed(const std::vector<Measurement>& readings, const std::string& text);

/// Returns a function that applies `change` only to the readings with these ids. `change` must not remove readings.
[[nodiscard]] std::function<void(std::vector<Measurement>&)> changeOf(
    std::set<std::string> ids, std::function<void(std::vector<Measurement>&)> change);

/// Returns a copy of the correction `whole` that applies only to reading `id` and all later ones; nullopt if there is
/// no such reading.
[[nodiscard]] std::optional<Mend> fromReading(const CheckedReadings& checked, Mend whole, const std::string& id);

}  // namespace tubeplan::calibration
