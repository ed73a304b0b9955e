#include "calibration/measurement_checks/stale_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "calibration/measurement_checks/check_words.hpp"
#include "calibration/measurements/reading_prediction.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

namespace {

constexpr double kGross = 10;      // times what most readings are off by, and their noise: no law leaves one reading so
constexpr std::size_t kLeast = 6;  // readings, by which it is known what most are off by
constexpr double kMostOfThem = 0.2;  // of the readings: of more, their joints are not what is wrong

/// Joints, set-up, loads and point: what two readings of one posture have alike.
using Station = std::pair<std::vector<double>, std::string>;

Station stationOf(const Measurement& reading) {
  std::vector<double> numbers(reading.q.begin(), reading.q.end());
  numbers.insert(numbers.end(), reading.side_q.begin(), reading.side_q.end());
  numbers.push_back(reading.load);
  return {std::move(numbers), reading.setup};
}

/// Length of a reading's error by the model [m], as its kind counts it; not a number of touches of unknown places, and
/// where the model cannot be evaluated.
double errorOf(const PlacedArm& placed, const Measurement& reading) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (hasUnknownPlace(reading)) return kNone;
  const auto& X_WB = placed.base_poses[static_cast<std::size_t>(basePoseOf(placed, reading))].X_WB;
  const Prediction predicted = predictReading(placed.arm, X_WB, reading);
  return predicted.ok ? (predicted.value - kindOf(reading).measured(reading)).norm() : kNone;
}

/// A reading, and the one whose joints it states.
struct Stale {
  std::size_t reading = 0, of = 0;
};

std::vector<Stale> staleAmong(const std::vector<Measurement>& readings, const std::vector<double>& errors) {
  std::vector<double> known;
  std::copy_if(errors.begin(), errors.end(), std::back_inserter(known), [](double e) { return std::isfinite(e); });
  if (known.size() < kLeast) return {};
  const double usual = median(std::move(known));
  const auto isGross = [&](std::size_t k) { return errors[k] > kGross * std::max(usual, readings[k].sigma); };
  std::map<Station, std::vector<std::size_t>> stations;
  for (std::size_t k = 0; k < readings.size(); ++k) stations[stationOf(readings[k])].push_back(k);
  std::vector<Stale> stale;
  for (const auto& [station, members] : stations)
    for (const std::size_t k : members) {
      if (!isGross(k)) continue;
      const auto near = std::find_if(members.rbegin(), members.rend(), [&](std::size_t other) {
        return other != k && std::isfinite(errors[other]) && !isGross(other);
      });
      if (near != members.rend()) stale.push_back({k, *near});
    }
  std::sort(stale.begin(), stale.end(), [](const Stale& a, const Stale& b) { return a.reading < b.reading; });
  return stale;
}

std::string distanceText(const CheckedReadings& checked, const Stale& stale) {
  const Measurement &reading = checked.readings[stale.reading], &of = checked.readings[stale.of];
  if (!statesPlace(reading) || !statesPlace(of)) return "";
  const auto& unit = checked.units.coordinates;
  return fmt::format(", {:.3g} {} from there", (*reading.p_W - *of.p_W).norm() / unit.factor, unit.name);
}

/// Root mean square of the errors that are known [m], all or those of readings that are not stale.
double rmsOf(const std::vector<double>& errors, const std::vector<Stale>& without) {
  double sum = 0;
  int count = 0;
  for (std::size_t k = 0; k < errors.size(); ++k) {
    if (!std::isfinite(errors[k]) || std::ranges::find(without, k, &Stale::reading) != without.end()) continue;
    sum += errors[k] * errors[k];
    ++count;
  }
  return std::sqrt(sum / std::max(1, count));
}

}  // namespace

std::optional<MeasurementCheck> staleJoints(const CheckedReadings& checked, const PlacedArm& found) {
  std::vector<double> errors;
  for (const auto& reading : checked.readings) errors.push_back(errorOf(found, reading));
  const auto stale = staleAmong(checked.readings, errors);
  if (stale.empty() || static_cast<double>(stale.size()) > kMostOfThem * static_cast<double>(checked.readings.size()))
    return std::nullopt;
  std::vector<std::string> ids, pairs;
  for (const Stale& one : stale) {
    const std::string &id = checked.readings[one.reading].id, &of = checked.readings[one.of].id;
    ids.push_back(id);
    pairs.push_back(id + " those of " + of + distanceText(checked, one));
  }
  return MeasurementCheck{"stale-joints",
                          CheckSeverity::kMistake,
                          fmt::format("{} the joints of another reading, and what was measured does not belong there: "
                                      "{}; the joints were logged too early, or copied",
                                      ids.size() == 1 ? "a reading states" : "readings state", listOf(pairs)),
                          rmsOf(errors, {}),
                          rmsOf(errors, stale),
                          assumeWithout(ids),
                          {}};
}

}  // namespace tubeplan::calibration
