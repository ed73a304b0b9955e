#include "calibration/measurement_checks/part_in_unit.hpp"

#include <algorithm>
#include <optional>

#include "calibration/measurement_checks/angles_unit.hpp"
#include "calibration/measurement_checks/coordinates_unit.hpp"
#include "calibration/measurement_checks/from_measurement.hpp"
#include "calibration/measurement_checks/row_comparison.hpp"

namespace tubeplan::calibration::mistakes::part_in_unit {

namespace {

constexpr std::size_t kMostComparedRows = 2000;
constexpr std::size_t kShortest = 2;  // shortest run [rows]; a single wrong measurement may have any cause

/// Returns the run of rows with the largest sum of RowComparison::at() (Kadane's algorithm), searched at a fixed stride
/// and then extended row by row at both ends; nullopt if no run is significant.
std::optional<Run> bestRun(RowComparison& comparison, std::size_t count) {
  const std::size_t stride = (count + kMostComparedRows - 1) / kMostComparedRows;
  double best = 0, sum = 0;
  Run run, found;
  for (std::size_t k = 0; k < count; k += stride) {
    if (sum <= 0) sum = 0, run.first = k;
    sum += comparison.at(k);
    if (sum > best) best = sum, found = {run.first, k};
  }
  const std::size_t compared = (found.last - found.first) / stride + 1;
  if (best < RowComparison::kLeastMean * static_cast<double>(compared)) return std::nullopt;
  for (std::size_t remaining = stride - 1; remaining > 0 && found.first > 0 && comparison.at(found.first - 1) > 0;
       --remaining)
    --found.first;
  for (std::size_t remaining = stride - 1; remaining > 0 && found.last + 1 < count && comparison.at(found.last + 1) > 0;
       --remaining)
    ++found.last;
  const std::size_t length = found.last - found.first + 1;
  return length >= kShortest && length < count ? std::optional(found) : std::nullopt;
}

std::vector<std::string> valuesOf(const MistakeKind& mistake_of_all, const CheckedMeasurements& checked) {
  std::vector<std::string> values;
  const auto units = mistake_of_all.values(checked);
  if (units.empty()) return values;
  const double reach = deflection::reachOf(checked.start.arm);
  for (const PlacedArm& placed : likelyPlacings(checked)) {
    RowErrors as_is(placed, checked.measurements);
    for (const auto& unit : units) {
      auto measurements = checked.measurements;
      mistake_of_all.correction(checked, unit)->change(measurements);
      RowErrors corrected(placed, measurements);
      RowComparison comparison(as_is, corrected, reach);
      const auto run = bestRun(comparison, measurements.size());
      if (!run) continue;
      auto value = textOf(*run, checked.measurements) + ":" + unit;
      if (std::ranges::find(values, value) == values.end()) values.push_back(std::move(value));
    }
  }
  return values;
}

std::optional<Correction> correctionOf(const MistakeKind& mistake_of_all, const CheckedMeasurements& checked,
                                       const std::string& value) {
  const auto [part, unit] = partedAtColon(value);
  const auto run = runNamed(checked.measurements, part);
  const auto all = mistake_of_all.correction(checked, unit);
  if (!run || !all) return std::nullopt;
  const std::string &first = checked.measurements[run->first].id, &last = checked.measurements[run->last].id;
  Correction correction{
      all->mistake + "-of", value,
      "in reading" + (first == last ? " " + first : "s " + first + " to " + last) + " " + all->sentence};
  correction.is_of_part = true;
  const auto ids = idsOf(*run, checked.measurements);
  correction.change = changeOf(ids, all->change);
  if (all->change_sigma) correction.change_sigma = changeOf(ids, all->change_sigma);
  return correction;
}

}  // namespace

MistakeKind coordinates() {
  return {"coordinates-of", "FIRST..LAST:UNIT", "two readings and a unit of length, such as 81..120:mm",
          [](const CheckedMeasurements& checked) { return valuesOf(coordinates_unit::kind(), checked); },
          [](const CheckedMeasurements& checked, const std::string& value) {
            return correctionOf(coordinates_unit::kind(), checked, value);
          }};
}

MistakeKind angles() {
  return {"angles-of", "FIRST..LAST:UNIT", "two readings and a unit of angle, such as 81..120:rad",
          [](const CheckedMeasurements& checked) { return valuesOf(angles_unit::kind(), checked); },
          [](const CheckedMeasurements& checked, const std::string& value) {
            return correctionOf(angles_unit::kind(), checked, value);
          }};
}

}  // namespace tubeplan::calibration::mistakes::part_in_unit
