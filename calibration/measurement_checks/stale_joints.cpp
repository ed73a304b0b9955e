#include "calibration/measurement_checks/stale_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "calibration/measurement_checks/check_words.hpp"
#include "calibration/measurement_checks/from_measurement.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

namespace {

// Smallest ratio of a gross error to the usual error and to the noise; no physical effect gives a single measurement
// such an error.
constexpr double kGross = 10;
constexpr std::size_t kLeast = 6;  // smallest number of errors that determines the usual error
// If more than this fraction of the measurements is stale, copied joints are not the cause, unless the measurements are
// consecutive.
constexpr double kMostOfThem = 0.2;
constexpr double kMostOfRun = 0.4;  // largest accepted fraction of stale measurements if these are consecutive

/// Values of a measurement that are compared with another measurement, and the set-up.
using Station = std::pair<std::vector<double>, std::string>;

/// Returns the joint values and the load, which together determine the posture.
std::optional<Station> jointsOf(const Measurement& measurement) {
  std::vector<double> numbers(measurement.q.begin(), measurement.q.end());
  numbers.insert(numbers.end(), measurement.side_q.begin(), measurement.side_q.end());
  numbers.push_back(measurement.load);
  return Station{std::move(numbers), measurement.setup};
}

/// Returns the position that an instrument measured; nullopt for touches, because a point may be touched repeatedly.
std::optional<Station> placeMeasured(const Measurement& measurement) {
  const auto& kind = kindOf(measurement);
  if (!measurement.p_W || !kind.is_place || kind.is_touch || kind.has_anchor) return std::nullopt;
  return Station{{measurement.p_W->begin(), measurement.p_W->end()}, measurement.setup};
}

/// Part of a measurement, its joints or its measured position, that may be stale, with the wording of its messages.
struct Side {
  const char *name, *singular, *plural, *cause;
  std::optional<Station> (*of)(const Measurement&);
};

constexpr Side kSides[] = {
    {"stale-joints", "a reading has the joint values of another reading, which do not fit its measured values",
     "readings have the joint values of another reading, which do not fit their measured values",
     "the joints were logged too early, or copied", jointsOf},
    {"stale-places", "a reading has exactly the coordinates of another reading, but the arm was elsewhere",
     "readings have exactly the coordinates of another reading, but the arm was elsewhere",
     "the tracker was not updated while the arm moved, or the coordinates were copied", placeMeasured}};

/// Returns the norm of a measurement's residual [m]; NaN for touches of unknown points, and if the model cannot be
/// evaluated.
double errorOf(const PlacedArm& placed, const Measurement& measurement) {
  if (hasUnknownPlace(measurement)) return kNotKnown;
  const Prediction predicted = predictMeasurement(placed, measurement);
  return predicted.ok ? (predicted.value - kindOf(measurement).measured(measurement)).norm() : kNotKnown;
}

/// Index of a stale measurement, and index of the measurement whose values it repeats.
struct Stale {
  std::size_t measurement = 0, of = 0;
};

std::vector<Stale> staleAmong(const std::vector<Measurement>& measurements, const std::vector<double>& errors,
                              const Side& side) {
  std::vector<double> known;
  std::ranges::copy_if(errors, std::back_inserter(known), [](double e) { return std::isfinite(e); });
  if (known.size() < kLeast) return {};
  const double usual = median(std::move(known));
  const auto isGross = [&](std::size_t k) { return errors[k] > kGross * std::max(usual, measurements[k].sigma); };
  std::map<Station, std::vector<std::size_t>> stations;
  for (std::size_t k = 0; k < measurements.size(); ++k)
    if (auto station = side.of(measurements[k])) stations[std::move(*station)].push_back(k);
  std::vector<Stale> stale;
  for (const auto& [station, members] : stations)
    for (const std::size_t k : members) {
      if (!isGross(k)) continue;
      const auto near = std::find_if(members.rbegin(), members.rend(), [&](std::size_t other) {
        return other != k && std::isfinite(errors[other]) && !isGross(other);
      });
      if (near != members.rend()) stale.push_back({k, *near});
    }
  std::ranges::sort(stale, {}, &Stale::measurement);
  return stale;
}

std::string distanceText(const CheckedMeasurements& checked, const Stale& stale) {
  const Measurement &measurement = checked.measurements[stale.measurement], &of = checked.measurements[stale.of];
  if (!statesPlace(measurement) || !statesPlace(of) || *measurement.p_W == *of.p_W) return "";
  const auto& unit = checked.units.coordinates;
  return fmt::format(", {:.3g} {} from there", (*measurement.p_W - *of.p_W).norm() / unit.factor, unit.name);
}

/// Returns the root mean square of the finite errors [m], except those of the given stale measurements.
double rmsOf(const std::vector<double>& errors, const std::vector<Stale>& without) {
  double sum = 0;
  int count = 0;
  for (std::size_t k = 0; k < errors.size(); ++k) {
    if (!std::isfinite(errors[k]) || std::ranges::find(without, k, &Stale::measurement) != without.end()) continue;
    sum += errors[k] * errors[k];
    ++count;
  }
  return std::sqrt(sum / std::max(1, count));
}

bool isRun(const std::vector<Stale>& stale) {
  return stale.size() > 1 && stale.back().measurement - stale.front().measurement + 1 == stale.size();
}

std::optional<MeasurementCheck> staleOf(const Side& side, const CheckedMeasurements& checked,
                                        const std::vector<double>& errors) {
  const auto stale = staleAmong(checked.measurements, errors, side);
  const double most = isRun(stale) ? kMostOfRun : kMostOfThem;
  if (stale.empty() || static_cast<double>(stale.size()) > most * static_cast<double>(checked.measurements.size()))
    return std::nullopt;
  std::vector<std::string> ids, pairs;
  for (const Stale& stale_part : stale) {
    const std::string &id = checked.measurements[stale_part.measurement].id,
                      &of = checked.measurements[stale_part.of].id;
    ids.push_back(id);
    pairs.push_back(id + (side.of == jointsOf ? " those of " : " that of ") + of + distanceText(checked, stale_part));
  }
  return MeasurementCheck{
      side.name,
      CheckSeverity::kMistake,
      fmt::format("{}: {}; {}", ids.size() == 1 ? side.singular : side.plural, listOf(pairs), side.cause),
      rmsOf(errors, {}),
      rmsOf(errors, stale),
      isRun(stale) ? "without=" + textOf({stale.front().measurement, stale.back().measurement}, checked.measurements)
                   : assumeWithout(ids),
      {}};
}

}  // namespace

std::vector<MeasurementCheck> staleMeasurements(const CheckedMeasurements& checked, const PlacedArm& found) {
  std::vector<double> errors;
  for (const auto& measurement : checked.measurements) errors.push_back(errorOf(found, measurement));
  std::vector<MeasurementCheck> checks;
  for (const Side& side : kSides)
    if (auto check = staleOf(side, checked, errors)) checks.push_back(std::move(*check));
  return checks;
}

}  // namespace tubeplan::calibration
