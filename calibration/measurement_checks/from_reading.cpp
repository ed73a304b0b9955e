#include "calibration/measurement_checks/from_reading.hpp"

#include <algorithm>
#include <string_view>

namespace tubeplan::calibration {

std::pair<std::string, std::optional<std::string>> partedAtReading(const std::string& value) {
  const std::size_t at = value.find('@');
  if (at == std::string::npos) return {value, std::nullopt};
  return {value.substr(0, at), value.substr(at + 1)};
}

std::set<std::string> idsFrom(const std::vector<Measurement>& readings, const std::string& id) {
  std::set<std::string> ids;
  for (auto reading = std::ranges::find(readings, id, &Measurement::id); reading != readings.end(); ++reading)
    ids.insert(reading->id);
  return ids;
}

std::set<std::string> idsNamed(const std::vector<Measurement>& readings, const std::string& text) {
  const auto find = [&](const std::string& id) { return std::ranges::find(readings, id, &Measurement::id); };
  if (find(text) != readings.end()) return {text};
  constexpr std::string_view kTo = "..";
  const std::size_t to = text.find(kTo);
  if (to == std::string::npos) return {};
  const auto first = find(text.substr(0, to)), last = find(text.substr(to + kTo.size()));
  std::set<std::string> ids;
  if (last == readings.end()) return ids;
  for (auto reading = first; reading <= last; ++reading) ids.insert(reading->id);
  return ids;
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
