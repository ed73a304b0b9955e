#include "app/documents/discrimination_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "app/documents/figures.hpp"
#include "app/documents/figures_text.hpp"
#include "app/documents/fill_in_json.hpp"
#include "app/formats/arm/joint_units.hpp"
#include "app/formats/measurements/measurements_writer.hpp"
#include "app/storage/count_text.hpp"
#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::app {

namespace {

using calibration::Measurement, calibration::ProposedMeasurement, calibration::MeasurementCandidate,
    calibration::DiscriminatedPair, calibration::DiscriminatingMeasurement, calibration::DiscriminatingMeasurements,
    calibration::DiscriminationStatus;

std::string explanationName(const DiscriminatingMeasurements& result, int index) {
  return calibration::nameOf(result.explanations[static_cast<std::size_t>(index)]);
}

/// Returns true if the measurement is taken at a hole or mark with a known position.
bool isAtPoint(const ProposedMeasurement& measurement) {
  return calibration::kindOf(measurement.kind).names_hole && measurement.known_W;
}

/// Returns the JSON of a chosen measurement. Touches of the same unknown point share a name such as N1; a hole or known
/// point has its own name.
nlohmann::json chosenMeasurementJson(const DiscriminatingMeasurements& result, const DiscriminatingMeasurement& chosen,
                                     std::size_t number, const ProposedMeasurement& measurement,
                                     const deflection::Arm& arm, const Units& units) {
  const Eigen::VectorXd joints = measurement.q.cwiseQuotient(jointFactors(arm, units));
  const auto names = deflection::jointNames(arm);
  nlohmann::json json = {{"kind", calibration::kindOf(measurement.kind).name},
                         {"posture", nlohmann::json::object()},
                         {"load", rounded(units.toFile(measurement.load, dimension::kForce))},
                         {"splits", {explanationName(result, chosen.a), explanationName(result, chosen.b)}},
                         {"separation_sigmas", finiteJson(chosen.separation)},
                         {"point", nullptr}};
  for (std::size_t j = 0; j < names.size(); ++j)
    json["posture"][names[j]] = rounded(joints[static_cast<Eigen::Index>(j)]);
  if (!measurement.approach_directions.empty()) json["senses"] = nlohmann::json::object();
  for (std::size_t j = 0; j < measurement.approach_directions.size(); ++j)
    json["senses"][names[j]] = measurement.approach_directions[j];
  if (touchesUnknownPoint(measurement)) json["point"] = "N" + std::to_string(number + 1);
  if (measurement.surface) json["point"] = measurement.point;
  if (isAtPoint(measurement)) {
    json["point"] = measurement.point;
    json["place"] = vectorJson(*measurement.known_W, units, dimension::kLength);
  }
  json["fill_in"] = fillInJson(fillInOf(measurement, arm, units));
  return json;
}

const std::vector<ProposedMeasurement>& measurementsOf(const std::vector<MeasurementCandidate>& candidates,
                                                       const DiscriminatingMeasurement& chosen) {
  return candidates[static_cast<std::size_t>(chosen.candidate)].measurements;
}

nlohmann::json pairJson(const DiscriminatingMeasurements& result, const DiscriminatedPair& pair) {
  return {{"if_true", explanationName(result, pair.truth)},
          {"against", explanationName(result, pair.other)},
          {"criterion_gap_now", finiteJson(pair.now)},
          {"criterion_gap_expected", finiteJson(pair.expected)},
          {"probability_distinguished", finiteJson(pair.probability)}};
}

std::string firstMeans(const DiscriminatingMeasurements& result) {
  std::vector<std::string> some;
  for (std::size_t k = 0; k < result.alternative_measurements.size() && k < 2; ++k)
    some.push_back(result.alternative_measurements[k].what);
  return fmt::format("{}", fmt::join(some, ", or "));
}

/// Returns a string such as "A and B" that names the first pair of explanations that cannot be distinguished, and
/// states the number of further pairs.
std::string neverText(const DiscriminatingMeasurements& result) {
  const auto& first = result.never.front();
  const std::string more = result.never.size() > 1 ? fmt::format(" (and {} pairs more)", result.never.size() - 1) : "";
  return explanationName(result, first.truth) + " and " + explanationName(result, first.other) + more;
}

constexpr TextLine kNextMeasurementWords[] = {
    {"", " {load:>8.4r}{posture:*11.7r}   {splits/0} from {splits/1}: {separation_sigmas:.1f}"},
    {"senses", "  (senses {senses})", {}, {}, 1},
    {"", "\n"}};

constexpr TextLine kNextMeasurementsWords[] = {
    {"splitting/advice", "next: {}\n"},
    {"next_readings", "{heading}   discriminates, by so many standard deviations\n", {}, {}, 1},
    {"next_readings", "  {place_name:<10}", kNextMeasurementWords}};

}  // namespace

std::string discriminationAdvice(const DiscriminatingMeasurements& result) {
  std::string advice;
  const std::size_t count = result.measurements.size();
  const std::string what = result.never.empty() ? "them" : "the others";
  const std::string chance =
      result.never.empty() ? fmt::format(" (probability {:.0f} %)", 100 * result.probability) : "";
  if (result.times == 1)
    advice = fmt::format("{} would discriminate between {}{}.", countText(count, "further reading"), what, chance);
  else if (result.times > 1)
    advice = fmt::format("It takes about {} further readings to discriminate between {}; the best {} are listed{}.",
                         static_cast<std::size_t>(result.times) * count, what, count, chance);
  if (!result.never.empty())
    advice = fmt::format("Further readings of this kind hardly discriminate between {}; instead, {}.{}{}",
                         neverText(result), firstMeans(result), advice.empty() ? "" : " ", advice);
  else if (result.times == 0 && !result.alternative_measurements.empty())
    advice = fmt::format("No further reading of this kind can be made; instead, {}.", firstMeans(result));
  for (const auto& column : result.columns) advice += fmt::format("{}Also {}.", advice.empty() ? "" : " ", column);
  return advice;
}

void addNextMeasurements(const DiscriminatingMeasurements& result, const std::vector<MeasurementCandidate>& candidates,
                         const deflection::Arm& arm, const Units& units, nlohmann::json& diagnosis) {
  diagnosis["next_readings"] = nlohmann::json::array();
  if (result.status == DiscriminationStatus::kNotRun) return;
  for (std::size_t k = 0; result.times > 0 && k < result.measurements.size(); ++k)
    for (const auto& measurement : measurementsOf(candidates, result.measurements[k]))
      diagnosis["next_readings"].push_back(
          chosenMeasurementJson(result, result.measurements[k], k, measurement, arm, units));
  nlohmann::json discrimination = {{"advice", discriminationAdvice(result)},
                                   {"can_be_split", result.times > 0},
                                   {"times_needed", result.times},
                                   {"criterion_gap_expected", finiteJson(result.least_expected)},
                                   {"probability_named", finiteJson(result.probability)},
                                   {"columns_to_add", result.columns},
                                   {"pairs", nlohmann::json::array()},
                                   {"never_split", nlohmann::json::array()},
                                   {"other_means", nlohmann::json::array()}};
  for (const auto& pair : result.pairs) discrimination["pairs"].push_back(pairJson(result, pair));
  for (const auto& pair : result.never)
    discrimination["never_split"].push_back({explanationName(result, pair.truth), explanationName(result, pair.other)});
  for (const auto& means : result.alternative_measurements)
    discrimination["other_means"].push_back(
        {{"what", means.what}, {"criterion_gap_expected", finiteJson(means.least_expected)}});
  if (!discriminationAdvice(result).empty())
    diagnosis["sentence"] = diagnosis["sentence"].get<std::string>() + " " + discriminationAdvice(result);
  diagnosis["splitting"] = std::move(discrimination);
}

std::vector<ProposedMeasurement> runSheetOf(const DiscriminatingMeasurements& result,
                                            const std::vector<MeasurementCandidate>& candidates,
                                            const std::vector<Measurement>& taken) {
  std::vector<ProposedMeasurement> sheet;
  if (result.times == 0) return sheet;
  std::set<std::string> used;
  for (const auto& measurement : taken) used.insert(measurement.id), used.insert(measurement.point);
  int number = 0;
  const auto fresh = [&] {
    std::string name = fmt::format("N{}", ++number);
    while (used.contains(name)) name = fmt::format("N{}", ++number);
    return name;
  };
  for (const auto& chosen : result.measurements) {
    const std::string point = fresh();
    const auto& measurements = measurementsOf(candidates, chosen);
    for (std::size_t k = 0; k < measurements.size(); ++k) {
      ProposedMeasurement measurement = measurements[k];
      measurement.id = k == 0 ? point : fresh();
      if (touchesUnknownPoint(measurement)) measurement.point = point;
      sheet.push_back(std::move(measurement));
    }
  }
  return sheet;
}

std::string discriminationText(nlohmann::json figures) {
  std::string heading = textOf(figures, "  point      {units/force:>8}");
  int number = 0;
  for (auto& measurement : figures["next_readings"]) {
    ++number;
    measurement["place_name"] =
        measurement["point"].is_null() ? nlohmann::json("N" + std::to_string(number)) : measurement["point"];
  }
  if (!figures["next_readings"].empty())
    for (const auto& [name, value] : figures["next_readings"].front()["posture"].items())
      heading += fmt::format(" {:>10}", name);
  figures["heading"] = heading;
  return textOf(figures, kNextMeasurementsWords);
}

}  // namespace tubeplan::app
