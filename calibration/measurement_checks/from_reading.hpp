// Mistakes of some of the readings: from one of them on, "VALUE@READING", or of a run, "FIRST..LAST".
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration {

/// Returns the value, and the reading from which on it holds; no reading if it holds for all.
[[nodiscard]] std::pair<std::string, std::optional<std::string>> partedAtReading(const std::string& value);

/// Returns the ids of a reading and of all following ones; empty if there is no such reading.
[[nodiscard]] std::set<std::string> idsFrom(const std::vector<Measurement>& readings, const std::string& id);

/// Consecutive readings, by their indices.
struct Run {
  std::size_t first = 0, last = 0;
};

/// Returns the run named by "FIRST..LAST"; nothing if one is no reading, or if the last comes before the first.
[[nodiscard]] std::optional<Run> runNamed(const std::vector<Measurement>& readings, const std::string& text);

/// Returns the name "FIRST..LAST" of a run.
[[nodiscard]] std::string textOf(const Run& run, const std::vector<Measurement>& readings);

[[nodiscard]] std::set<std::string> idsOf(const Run& run, const std::vector<Measurement>& readings);

/// Returns the id itself if it is a reading, or the ids of the run "FIRST..LAST"; empty if there is neither.
[[nodiscard]] std::set<std::string> idsNamed(const std::vector<Measurement>& readings, const std::string& text);

/// Returns the change limited to the readings of these ids. The change must not remove readings.
[[nodiscard]] std::function<void(std::vector<Measurement>&)> changeOf(
    std::set<std::string> ids, std::function<void(std::vector<Measurement>&)> change);

/// Returns the correction `whole` limited to the readings from `id` on; nothing if there is no such reading.
[[nodiscard]] std::optional<Mend> fromReading(const CheckedReadings& checked, Mend whole, const std::string& id);

}  // namespace tubeplan::calibration
