#include "calibration/measurement_checks/copies.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "calibration/measurement_checks/check_words.hpp"
#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::calibration {

namespace {

/// Returns the values that are all equal in a measurement and its copy. A row that was logged again has a later time;
/// only a second count of steps at a later time is an independent measurement.
auto contentOf(const Measurement& m) {
  const Eigen::Vector3d p = m.p_W.value_or(Eigen::Vector3d::Zero());
  const Eigen::Vector3d tool = m.p_TQ.value_or(Eigen::Vector3d::Zero());
  const Eigen::Vector3d direction = m.direction_W.value_or(Eigen::Vector3d::Zero());
  const TipWrench wrench = m.wrench.value_or(TipWrench{});
  const auto number = [](double value) { return std::isfinite(value) ? value : 0; };
  std::vector<double> conditions;
  for (const auto& kind : deflection::kConditionKinds)
    if (kind.course != deflection::Course::kSlow || kindOf(m).counts_steps)
      conditions.push_back(number(m.conditions[kind.condition]));
  return std::tuple{static_cast<int>(m.kind),
                    m.row,
                    m.point,
                    m.setup,
                    m.reference ? m.reference->id : "",
                    m.approach_directions,
                    std::vector<double>(direction.begin(), direction.end()),
                    m.load,
                    std::vector<double>(m.q.begin(), m.q.end()),
                    std::vector<double>(m.side_q.begin(), m.side_q.end()),
                    std::vector<double>(wrench.force_W.begin(), wrench.force_W.end()),
                    std::vector<double>(wrench.moment_W.begin(), wrench.moment_W.end()),
                    p.x(),
                    p.y(),
                    p.z(),
                    std::vector<double>(tool.begin(), tool.end()),
                    number(m.kind_values[0]),
                    number(m.kind_values[1]),
                    number(m.kind_values[2]),
                    conditions};
}

/// Index of a measurement, and index of the earlier measurement with the same values.
struct Copy {
  std::size_t measurement = 0, of = 0;
};

std::vector<Copy> copiesIn(const std::vector<Measurement>& measurements) {
  std::map<decltype(contentOf(measurements.front())), std::size_t> first;
  std::vector<Copy> copies;
  for (std::size_t k = 0; k < measurements.size(); ++k)
    if (const auto [at, is_new] = first.emplace(contentOf(measurements[k]), k); !is_new)
      copies.push_back({k, at->second});
  return copies;
}

/// Returns the resolution of the written coordinates [m]: the largest power of ten in their unit that divides all
/// coordinates.
double stepOfCoordinates(const CheckedMeasurements& checked) {
  constexpr double kCoarsest = 1, kFinest = 1e-7;
  for (double step = kCoarsest; step > kFinest; step /= 10) {
    const auto isWhole = [&](double metres) {
      const double steps = metres / checked.units.coordinates.factor / step;
      return std::abs(steps - std::round(steps)) < 1e-3;
    };
    const bool are_whole = std::ranges::all_of(checked.measurements, [&](const Measurement& m) {
      return !m.p_W || !kindOf(m).has_coordinates || std::all_of(m.p_W->begin(), m.p_W->end(), isWhole);
    });
    if (are_whole) return step * checked.units.coordinates.factor;
  }
  return kFinest * checked.units.coordinates.factor;
}

std::string copiesText(const CheckedMeasurements& checked, const std::vector<Copy>& copies) {
  std::vector<std::string> names;
  for (const Copy& copy : copies)
    names.push_back(checked.measurements[copy.measurement].id + " (as " + checked.measurements[copy.of].id + ")");
  return listOf(names);
}

}  // namespace

std::optional<MeasurementCheck> duplicates(const CheckedMeasurements& checked) {
  const auto copies = copiesIn(checked.measurements);
  if (copies.empty()) return std::nullopt;
  std::vector<std::string> ids;
  for (const Copy& copy : copies) ids.push_back(checked.measurements[copy.measurement].id);
  return remarkOf("duplicates",
                  std::string(ids.size() == 1 ? "a reading occurs" : "readings occur") +
                      " twice with identical numbers: " + copiesText(checked, copies),
                  assumeWithout(ids));
}

std::optional<MeasurementCheck> takeCopiesOut(CheckedMeasurements& checked) {
  // Equal coordinates indicate a copy only if their resolution is finer than this fraction of sigma: the chance that
  // two separate measurements agree in all three coordinates is then below 1e-4.
  constexpr double kFine = 0.1;
  const double step = stepOfCoordinates(checked);
  auto copies = copiesIn(checked.measurements);
  std::erase_if(copies, [&](const Copy& copy) {
    const Measurement& m = checked.measurements[copy.measurement];
    return !m.p_W || !kindOf(m).has_coordinates || !(step < kFine * m.sigma);
  });
  if (copies.empty()) return std::nullopt;
  MeasurementCheck check;
  check.name = "copies";
  check.sentence = std::string(copies.size() == 1 ? "a reading is a copy" : "readings are copies") +
                   " of another in all numbers and counted once: " + copiesText(checked, copies) +
                   "; --assume as-is counts every row";
  std::vector<int> places;
  for (const Copy& copy : copies) places.push_back(static_cast<int>(copy.measurement));
  checked.measurements = withoutMeasurements(std::move(checked.measurements), places);
  return check;
}

}  // namespace tubeplan::calibration
