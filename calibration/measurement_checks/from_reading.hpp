// Mistakes of a part of the readings: from one of them on, "VALUE@READING", or of a run, "FIRST..LAST".
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration {

/// The value, and the reading from which on it holds; none where it holds for all.
[[nodiscard]] std::pair<std::string, std::optional<std::string>> partedAtReading(const std::string& value);

/// The ids of a reading and of all that follow; empty where it is none of them.
[[nodiscard]] std::set<std::string> idsFrom(const std::vector<Measurement>& readings, const std::string& id);

/// Readings that follow one another, by their places.
struct Run {
  std::size_t first = 0, last = 0;
};

/// The run that "FIRST..LAST" names; nothing where one is no reading, or the last stands before the first.
[[nodiscard]] std::optional<Run> runNamed(const std::vector<Measurement>& readings, const std::string& text);

/// "FIRST..LAST".
[[nodiscard]] std::string textOf(const Run& run, const std::vector<Measurement>& readings);

[[nodiscard]] std::set<std::string> idsOf(const Run& run, const std::vector<Measurement>& readings);

/// The reading of that id alone, or the run that "FIRST..LAST" names; empty where there is none.
[[nodiscard]] std::set<std::string> idsNamed(const std::vector<Measurement>& readings, const std::string& text);

/// A change of the readings of these ids alone, others as they were. It must not leave readings out.
[[nodiscard]] std::function<void(std::vector<Measurement>&)> changeOf(
    std::set<std::string> ids, std::function<void(std::vector<Measurement>&)> change);

/// A mend of all readings as one of those from `id` on; nothing where there is no such reading.
[[nodiscard]] std::optional<Mend> fromReading(const CheckedReadings& checked, Mend whole, const std::string& id);

}  // namespace tubeplan::calibration
