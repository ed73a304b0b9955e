// Functions for mistakes that affect only some of the measurements: one measurement and all later ones, written
// "VALUE@READING", or a run of consecutive measurements, written "FIRST..LAST".
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration {

/// Splits "VALUE@READING" into the value and the id of the first measurement that it applies to. The id is nullopt if
/// the value applies to all measurements.
[[nodiscard]] std::pair<std::string, std::optional<std::string>> partedAtMeasurement(const std::string& value);

/// Returns `id` and the ids of all later measurements; empty if there is no such measurement.
[[nodiscard]] std::set<std::string> idsFrom(const std::vector<Measurement>& measurements, const std::string& id);

/// Consecutive measurements, given by the indices of the first and the last.
struct Run {
  std::size_t first = 0, last = 0;
};

/// Returns the run named by "FIRST..LAST"; nullopt if one of the two ids does not exist, or if LAST precedes FIRST.
[[nodiscard]] std::optional<Run> runNamed(const std::vector<Measurement>& measurements, const std::string& text);

/// Returns the name "FIRST..LAST" of a run of measurements.
[[nodiscard]] std::string textOf(const Run& run, const std::vector<Measurement>& measurements);

[[nodiscard]] std::set<std::string> idsOf(const Run& run, const std::vector<Measurement>& measurements);

/// Returns the ids that `text` names: `text` itself if it is the id of a measurement, or the ids of all measurements of
/// the run "FIRST..LAST"; empty if it is neither.
[[nodiscard]] std::set<std::string> idsNamed(const std::vector<Measurement>& measurements, const std::string& text);

/// Returns a function that applies `change` only to the measurements with these ids. `change` must not remove
/// measurements.
[[nodiscard]] std::function<void(std::vector<Measurement>&)> changeOf(
    std::set<std::string> ids, std::function<void(std::vector<Measurement>&)> change);

/// Returns a copy of `correction` that applies only to measurement `id` and all later ones; nullopt if there is no
/// such measurement.
[[nodiscard]] std::optional<Correction> fromMeasurement(const CheckedMeasurements& checked, Correction correction,
                                                        const std::string& id);

}  // namespace tubeplan::calibration
