#include "calibration/measurement_checks/rotation_search.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "calibration/measurement_checks/mistake_search.hpp"

namespace tubeplan::calibration {

namespace {

constexpr std::size_t kFewestPoses = 6;

/// Returns the measurements that state both a position and a rotation of the tool, converted to position measurements.
std::vector<Measurement> placesOfPoses(const std::vector<Measurement>& measurements) {
  std::vector<Measurement> places;
  for (Measurement measurement : measurements)
    if (statesFrame(measurement) && measurement.p_W && !measurement.row) {
      measurement.kind = MeasurementKind::kPosition;
      places.push_back(std::move(measurement));
    }
  return places;
}

/// Parses a string such as "joint-sign=q1,joint-sign=q4" into corrections, without corrections of the sigmas; empty if
/// one of them does not apply to these measurements.
JoinedCorrections correctionsOf(const CheckedMeasurements& checked, const std::string& assume) {
  JoinedCorrections corrections;
  for (const std::string& text : partedAssumptions(assume)) {
    const std::size_t equals = std::min(text.find('='), text.size() - 1);
    const auto* kind = findMistakeKind(text.substr(0, equals));
    if (kind && kind->settles_sigma) continue;
    auto correction = kind ? kind->correction(checked, text.substr(equals + 1)) : std::nullopt;
    if (!correction || correction->parts_setups) return {};
    corrections.push_back(std::move(*correction));
  }
  return corrections;
}

CheckedMeasurements takenBy(const MistakeTrials& trials, const JoinedCorrections& corrections) {
  CheckedMeasurements checked = trials.checked();
  if (corrections.empty()) return checked;
  const Correction all = joined(corrections);
  all.apply(checked.measurements);
  checked.start = trials.startOf(all);
  return checked;
}

/// Returns `before` combined with each correction of a mistake in rotations that is worth trying once `before` is
/// applied. Mistakes that must be corrected before the last correction of `before` are excluded.
std::vector<JoinedCorrections> withTurns(const MistakeTrials& trials, const JoinedCorrections& before) {
  std::vector<JoinedCorrections> all;
  const CheckedMeasurements corrected = takenBy(trials, before);
  const auto& kinds = mistakeKinds();
  auto kind = kinds.begin();
  if (!before.empty())
    kind = std::ranges::find_if(kinds,
                                [&](const MistakeKind& candidate) { return candidate.name == before.back().mistake; }) +
           1;
  for (; kind != kinds.end(); ++kind)
    if (kind->is_of_turns)
      for (const auto& value : kind->values(corrected))
        if (auto correction = kind->correction(corrected, value)) {
          all.push_back(before);
          all.back().push_back(std::move(*correction));
        }
  return all;
}

}  // namespace

std::vector<JoinedCorrections> likelyRotationMistakes(const MistakeTrials& trials) {
  const CheckedMeasurements& checked = trials.checked();
  std::vector<JoinedCorrections> likely;
  CheckedMeasurements places = checked;
  places.measurements = placesOfPoses(checked.measurements);
  if (places.measurements.size() < kFewestPoses) return likely;
  const MistakeTrials of_places(places, trials.options());
  const auto found = findMistake(of_places);
  if (found) {
    const auto corrections = correctionsOf(checked, found->check.assume);
    return corrections.empty() ? likely : withTurns(trials, corrections);
  }
  for (const auto& first : withTurns(trials, {}))
    for (auto& both : withTurns(trials, first)) likely.push_back(std::move(both));
  return likely;
}

}  // namespace tubeplan::calibration
