#include "calibration/measurement_checks/shifted_rows.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>

#include "calibration/measurement_checks/from_measurement.hpp"
#include "calibration/measurement_checks/row_comparison.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::calibration::mistakes::shifted_rows {

namespace {

constexpr std::size_t kMostRowsCompared = 2000;
constexpr std::size_t kFewest = 3;    // smallest number of rows before and after a lost point
constexpr int kTried[] = {-1, 1};     // tried shifts [rows] that begin within the table
constexpr double kNotShifted = 0.03;  // a row with a smaller error, relative to the reach, is not shifted

/// Copies the measured values of a measurement, but not its joints and loads.
void takeMeasured(const Measurement& from, Measurement& to) {
  to.kind = from.kind;
  to.point = from.point;
  to.p_W = from.p_W;
  to.direction_W = from.direction_W;
  to.p_TQ = from.p_TQ;
  to.kind_values = from.kind_values;
  to.row = from.row;
  to.reference = from.reference;
  to.sigma = from.sigma;
  to.sigma_W = from.sigma_W;
  to.correlation_W = from.correlation_W;
  to.turn_sigma = from.turn_sigma;
}

/// Parsed value such as "-1" or "-1@P37": the number of rows by which values are shifted, and the first shifted
/// measurement (nullopt for the whole table).
struct Shift {
  int by = 0;
  std::optional<std::string> from;
};

std::optional<Shift> shiftNamed(const std::string& value) {
  const auto [rows, from] = partedAtMeasurement(value);
  const auto by = tubesheets::parseInteger(rows);
  if (!by || *by == 0 || std::abs(*by) > 1000) return std::nullopt;
  return Shift{*by, from};
}

/// Returns all measurements, each with the measured values from `by` rows further down. Unlike shift(), keeps
/// measurements without such a row, but without a position.
std::vector<Measurement> inPlace(int by, const std::vector<Measurement>& measurements) {
  auto moved = measurements;
  const auto count = static_cast<int>(measurements.size());
  for (int k = 0; k < count; ++k) {
    Measurement& to = moved[static_cast<std::size_t>(k)];
    if (k + by >= 0 && k + by < count)
      takeMeasured(measurements[static_cast<std::size_t>(k + by)], to);
    else
      to.p_W.reset();
  }
  return moved;
}

/// Returns the first row of a shift that extends to the end of the table: the start that maximises the total evidence
/// for the corrected rows, moved to the nearest row at which errors above `fits` [m] begin. Returns nullopt if there is
/// none.
std::optional<std::size_t> startOf(RowComparison& comparison, RowErrors& as_is, std::size_t count, double fits) {
  const std::size_t stride = (count + kMostRowsCompared - 1) / kMostRowsCompared;
  double sum = 0, best = 0;
  std::size_t start = count, compared = 0, best_compared = 0;
  for (std::size_t k = count - count % stride; k >= stride; k -= stride) {
    sum += comparison.at(k - stride);
    ++compared;
    if (sum > best) best = sum, start = k - stride, best_compared = compared;
  }
  if (best_compared == 0 || best < RowComparison::kLeastMean * static_cast<double>(best_compared)) return std::nullopt;
  for (std::size_t remaining = stride + 1; remaining > 0 && start > 0 && as_is.at(start - 1) > fits; --remaining)
    --start;
  while (start < count && as_is.at(start) <= fits) ++start;
  return start >= kFewest && start + kFewest <= count ? std::optional(start) : std::nullopt;
}

std::vector<std::string> values(const CheckedMeasurements& checked) {
  const auto& measurements = checked.measurements;
  if (measurements.size() <= 3) return {};
  std::vector<std::string> values{"-1", "1"};
  const double reach = deflection::reachOf(checked.start.arm);
  for (const PlacedArm& placed : likelyPlacings(checked)) {
    RowErrors as_is(placed, measurements);
    for (const int by : kTried) {
      const auto moved = inPlace(by, measurements);
      RowErrors corrected(placed, moved);
      RowComparison comparison(as_is, corrected, reach);
      const auto start = startOf(comparison, as_is, measurements.size(), kNotShifted * reach);
      if (!start) continue;
      auto value = std::to_string(by) + "@" + measurements[*start].id;
      if (std::ranges::find(values, value) == values.end()) values.push_back(std::move(value));
    }
  }
  return values;
}

std::function<void(std::vector<Measurement>&)> changeFrom(int by, std::set<std::string> moved) {
  return [by, moved = std::move(moved)](std::vector<Measurement>& measurements) {
    const auto first = std::ranges::find_if(
        measurements, [&](const Measurement& measurement) { return moved.contains(measurement.id); });
    std::vector<Measurement> later(std::make_move_iterator(first), std::make_move_iterator(measurements.end()));
    measurements.erase(first, measurements.end());
    shift(by, later);
    std::ranges::move(later, std::back_inserter(measurements));
  };
}

std::optional<Correction> correctionOf(const CheckedMeasurements& checked, const std::string& value) {
  const auto named = shiftNamed(value);
  if (!named) return std::nullopt;
  const int by = named->by;
  const std::string rows = std::to_string(std::abs(by)) + (std::abs(by) == 1 ? " row" : " rows");
  Correction correction{
      "shift", value,
      "the measured values are " + rows + (by > 0 ? " below" : " above") + " the joint readings they belong to"};
  correction.change = [by](std::vector<Measurement>& measurements) { shift(by, measurements); };
  if (!named->from) return correction;
  auto moved = idsFrom(checked.measurements, *named->from);
  if (moved.empty()) return std::nullopt;
  correction.sentence = "from reading " + *named->from + " on " + correction.sentence +
                        (by < 0 ? ": a measured point was lost there" : ": a measured point was repeated or added");
  correction.change = changeFrom(by, std::move(moved));
  correction.is_of_part = true;
  return correction;
}

}  // namespace

void shift(int by, std::vector<Measurement>& measurements) {
  std::vector<Measurement> shifted;
  const auto count = static_cast<int>(measurements.size());
  for (int k = 0; k < count; ++k) {
    if (k + by < 0 || k + by >= count) continue;
    const Measurement& measured = measurements[static_cast<std::size_t>(k + by)];
    if (measured.setup != measurements[static_cast<std::size_t>(k)].setup) continue;
    shifted.push_back(measurements[static_cast<std::size_t>(k)]);
    takeMeasured(measured, shifted.back());
  }
  measurements = std::move(shifted);
}

MistakeKind kind() {
  return {"shift", "ROWS[@READING]",
          "number of rows by which the measured values are below their joint readings, such as 1 or -1, and the first "
          "such reading, as in -1@P37",
          values, correctionOf};
}

}  // namespace tubeplan::calibration::mistakes::shifted_rows
