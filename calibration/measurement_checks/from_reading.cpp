#include "calibration/measurement_checks/from_reading.hpp"

#include <algorithm>
#include <string_view>

namespace tubeplan::calibration {

namespace {

constexpr std::string_view kTo = "..";

/// Returns the index of the reading with this id; the number of readings if there is none.
std::size_t placeOf(const std::vector<Measurement>& readings, const std::string& id) {
  return static_cast<std::size_t>(std::ranges::find(readings, id, &Measurement::id) - readings.begin());
}

}  // namespace

std::pair<std::string, std::optional<std::string>> partedAtReading(const std::string& value) {
  const std::size_t at = value.find('@');
  if (at == std::string::npos) return {value, std::nullopt};
  return {value.substr(0, at), value.substr(at + 1)};
}

std::set<std::string> idsFrom(const std::vector<Measurement>& readings, const std::string& id) {
  const std::size_t first = placeOf(readings, id);
  return first < readings.size() ? idsOf({first, readings.size() - 1}, readings) : std::set<std::string>{};
}

std::optional<Run> runNamed(const std::vector<Measurement>& readings, const std::string& text) {
  const std::size_t to = text.find(kTo);
  if (to == std::string::npos) return std::nullopt;
  const Run run{placeOf(readings, text.substr(0, to)), placeOf(readings, text.substr(to + kTo.size()))};
  return run.first <= run.last && run.last < readings.size() ? std::optional(run) : std::nullopt;
}

std::string textOf(const Run& run, const std::vector<Measurement>& readings) {
  return readings[run.first].id + std::string(kTo) + readings[run.last].id;
}

std::set<std::string> idsOf(const Run& run, const std::vector<Measurement>& readings) {
  std::set<std::string> ids;
  for (std::size_t k = run.first; k <= run.last; ++k) ids.insert(readings[k].id);
  return ids;
}

std::set<std::string> idsNamed(const std::vector<Measurement>& readings, const std::string& text) {
  if (placeOf(readings, text) < readings.size()) return {text};
  const auto run = runNamed(readings, text);
  return run ? idsOf(*run, readings) : std::set<std::string>{};
}

std::function<void(std::vector<Measurement>&)> changeOf(std::set<std::string> ids,
                                                        std::function<void(std::vector<Measurement>&)> change) {
  return [ids = std::move(ids), change = std::move(change)](std::vector<Measurement>& readings) {
    auto changed = readings;
    change(changed);
    for (std::size_t k = 0; k < readings.size(); ++k)
      if (ids.contains(readings[k].id)) readings[k] = std::move(changed[k]);
  };
}

std::optional<Mend> fromReading(const CheckedReadings& checked, Mend whole, const std::string& id) {
  auto ids = idsFrom(checked.readings, id);
  if (ids.empty()) return std::nullopt;
  whole.value += "@" + id;
  whole.sentence = "from reading " + id + " on " + whole.sentence;
  whole.change = changeOf(std::move(ids), std::move(whole.change));
  whole.is_of_part = true;
  return whole;
}

}  // namespace tubeplan::calibration
