#include "calibration/measurement_checks/from_measurement.hpp"

#include <algorithm>
#include <string_view>

namespace tubeplan::calibration {

namespace {

constexpr std::string_view kTo = "..";

/// Returns the index of the measurement with this id; the number of measurements if there is none.
std::size_t placeOf(const std::vector<Measurement>& measurements, const std::string& id) {
  return static_cast<std::size_t>(std::ranges::find(measurements, id, &Measurement::id) - measurements.begin());
}

}  // namespace

std::pair<std::string, std::optional<std::string>> partedAtMeasurement(const std::string& value) {
  const std::size_t at = value.find('@');
  if (at == std::string::npos) return {value, std::nullopt};
  return {value.substr(0, at), value.substr(at + 1)};
}

std::set<std::string> idsFrom(const std::vector<Measurement>& measurements, const std::string& id) {
  const std::size_t first = placeOf(measurements, id);
  return first < measurements.size() ? idsOf({first, measurements.size() - 1}, measurements) : std::set<std::string>{};
}

std::optional<Run> runNamed(const std::vector<Measurement>& measurements, const std::string& text) {
  const std::size_t to = text.find(kTo);
  if (to == std::string::npos) return std::nullopt;
  const Run run{placeOf(measurements, text.substr(0, to)), placeOf(measurements, text.substr(to + kTo.size()))};
  return run.first <= run.last && run.last < measurements.size() ? std::optional(run) : std::nullopt;
}

std::string textOf(const Run& run, const std::vector<Measurement>& measurements) {
  return measurements[run.first].id + std::string(kTo) + measurements[run.last].id;
}

std::set<std::string> idsOf(const Run& run, const std::vector<Measurement>& measurements) {
  std::set<std::string> ids;
  for (std::size_t k = run.first; k <= run.last; ++k) ids.insert(measurements[k].id);
  return ids;
}

std::set<std::string> idsNamed(const std::vector<Measurement>& measurements, const std::string& text) {
  if (placeOf(measurements, text) < measurements.size()) return {text};
  const auto run = runNamed(measurements, text);
  return run ? idsOf(*run, measurements) : std::set<std::string>{};
}

std::function<void(std::vector<Measurement>&)> changeOf(std::set<std::string> ids,
                                                        std::function<void(std::vector<Measurement>&)> change) {
  return [ids = std::move(ids), change = std::move(change)](std::vector<Measurement>& measurements) {
    auto changed = measurements;
    change(changed);
    for (std::size_t k = 0; k < measurements.size(); ++k)
      if (ids.contains(measurements[k].id)) measurements[k] = std::move(changed[k]);
  };
}

std::optional<Correction> fromMeasurement(const CheckedMeasurements& checked, Correction correction,
                                          const std::string& id) {
  auto ids = idsFrom(checked.measurements, id);
  if (ids.empty()) return std::nullopt;
  correction.value += "@" + id;
  correction.sentence = "from reading " + id + " on " + correction.sentence;
  correction.change = changeOf(std::move(ids), std::move(correction.change));
  correction.is_of_part = true;
  return correction;
}

}  // namespace tubeplan::calibration
