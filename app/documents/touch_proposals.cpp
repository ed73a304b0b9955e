#include "app/documents/touch_proposals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/documents/figures.hpp"
#include "app/documents/figures_text.hpp"
#include "app/documents/fill_in_json.hpp"
#include "app/formats/arm/joint_units.hpp"
#include "app/formats/units.hpp"
#include "app/formats/units_json.hpp"
#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::app {

namespace {

using calibration::NumberForecast, calibration::ProposedMeasurement, calibration::TipSigma;

/// Proposed measurement with its name, and the index of the design step that chose the measurement.
struct NamedMeasurement {
  ProposedMeasurement measurement;
  std::size_t step;
};

/// Names the measurements T1, T2, ... for the base or N1, N2, ... for the parameters. Touches of one unknown point N1
/// are named N1a, N1b, ...
std::vector<NamedMeasurement> nameMeasurements(const TouchOutcome& outcome, const TouchProposal& proposal,
                                               char letter) {
  std::vector<NamedMeasurement> named;
  for (std::size_t s = 0; s < proposal.next.design.steps.size(); ++s) {
    const auto& measurements = proposal.chosen(proposal.next.design.steps[s]).measurements;
    const std::string name = letter + std::to_string(s + 1);
    for (std::size_t k = 0; k < measurements.size(); ++k) {
      ProposedMeasurement measurement = measurements[k];
      measurement.id = measurements.size() == 1 ? name : name + static_cast<char>('a' + k);
      if (touchesUnknownPoint(measurement)) measurement.point = name;
      measurement.setup = outcome.setup;
      named.push_back({std::move(measurement), s});
    }
  }
  return named;
}

nlohmann::json tipJson(const TipSigma& sigma, const Units& units) {
  const double unit = units.factor(dimension::kLength);
  return {{"rms", finiteJson(sigma.rms / unit)}, {"worst", finiteJson(sigma.worst / unit)}};
}

nlohmann::json proposedJointsJson(const TouchOutcome& outcome, const Eigen::VectorXd& q) {
  const Eigen::VectorXd joints = q.cwiseQuotient(jointFactors(outcome.cell.arm, outcome.cell.units));
  return vectorJson(joints, outcome.cell.units, dimension::kNone);
}

void appendMeasurements(const TouchOutcome& outcome, const TouchProposal& proposal, char letter, const char* goal,
                        nlohmann::json& list) {
  const Units& units = outcome.cell.units;
  for (const auto& [measurement, chosen_in] : nameMeasurements(outcome, proposal, letter)) {
    const auto& step = proposal.next.design.steps[chosen_in];
    nlohmann::json json = {{"id", measurement.id},
                           {"for", goal},
                           {"kind", calibration::kindOf(measurement.kind).name},
                           {"joints", proposedJointsJson(outcome, measurement.q)},
                           {"load", units.toFile(measurement.load, dimension::kForce)},
                           {"fill_in", fillInJson(fillInOf(measurement, outcome.cell.arm, units))},
                           {"adds",
                            {{"bits", finiteJson(step.bits)},
                             {"tip_sigma_then", tipJson(step.tip, units)},
                             {"helps", proposal.next.numbers[static_cast<std::size_t>(step.most_helped)].unknown.name},
                             {"its_sigma_times", finiteJson(step.helped_by)}}}};
    if (!measurement.point.empty()) json["point"] = measurement.point;
    if (measurement.known_W) json["place"] = vectorJson(*measurement.known_W, units, dimension::kLength);
    list.push_back(json);
  }
}

nlohmann::json numberJson(const NumberForecast& number, const Units& units) {
  const Dimension unit = dimensionOf(number.unknown.quantity);
  const double factor = units.factor(unit);
  return {{"name", number.unknown.name},
          {"value", finiteJson(number.value / factor)},
          {"unit", units.nameOf(unit)},
          {"sigma",
           {{"now", finiteJson(number.now / factor)},
            {"after", finiteJson(number.after / factor)},
            {"random", finiteJson(number.random / factor)}}},
          {"identifiable", {{"now", number.is_identifiable_now}, {"after", number.is_identifiable_after}}}};
}

nlohmann::json proposalJson(const TouchOutcome& outcome, const TouchProposal& proposal, const MeasurementNoise& noise) {
  if (!proposal.reason.empty()) return {{"reason", proposal.reason}};
  const auto& next = proposal.next;
  const Units& units = outcome.cell.units;
  nlohmann::json json = {{"candidates", next.candidates.size()},
                         {"sigma", lengthOf(noise.sigma, units)},
                         {"sigma_from", noise.from},
                         {"swaps", next.design.swaps},
                         {"tip_sigma",
                          {{"now", tipJson(next.tip_now, units)},
                           {"after", tipJson(next.tip_after, units)},
                           {"random", tipJson(next.tip_random, units)}}},
                         {"bits", {{"after", finiteJson(next.bits)}, {"random", finiteJson(next.bits_random)}}}};
  json["numbers"] = nlohmann::json::array();
  for (const auto& number : next.numbers) json["numbers"].push_back(numberJson(number, units));
  return json;
}

/// Returns true if the base is known or if the existing measurements determine it.
bool isPlaced(const calibration::NextMeasurements& next) {
  return std::all_of(next.numbers.begin(), next.numbers.end(), [](const NumberForecast& number) {
    return number.unknown.owner == calibration::Unknown::Owner::kArm || number.is_identifiable_now;
  });
}

constexpr std::string_view kTipSigmaRow = "  {@:<44} {rms:>10.4r} {worst:>10.4r}\n";
constexpr TextLine kTipSigmaWords[] = {
    {"", "  standard deviation of the tip at work, {units/length} per coordinate        rms      worst\n"},
    {"!is_placed", "  now                                          base not calibrated yet\n"},
    {"is_placed",
     "  now                                          {tip_sigma/now/rms:>10.4r} {tip_sigma/now/worst:>10.4r}\n"},
    {"tip_sigma/after", kTipSigmaRow, {}, "after these"},
    {"tip_sigma/random", kTipSigmaRow, {}, "after as many random ones (median)"},
    {"tip_sigma/nearest", kTipSigmaRow, {}, "after the nearest"},
    {"nearest_holes", "    which are {nearest_holes}\n", {}, {}, 1}};

constexpr TextLine kForecastWords[] = {
    {"", "", kTipSigmaWords},
    {"", "  sigma of the parameters                       now        after after random\n"},
    {"numbers",
     "  {name:<36} {sigma/now:>12.3r} {sigma/after:>12.3r} {sigma/random:>12.3r} {unit}  identifiable now: "
     "{identifiable/now}, after: {identifiable/after}\n"}};

constexpr TextLine kProposedWords[] = {
    {"point", "{:<9}"},
    {"!point", "         "},
    {"", " {load:>8.4r}{joints:*10.7r}   {adds/helps} (sigma x {adds/its_sigma_times:.2r})\n"}};

constexpr TextLine kProposalWords[] = {
    {"", "{work/postures} posture(|s) at work"},
    {"work/out_of_reach", ", {} tube(|s) out of reach"},
    {"", "\n"},
    {"notes", "  note: {}\n"},
    {"base/reason", "no touches for the base: {}\n"},
    {"base/candidates",
     "touches for the base: {count} of {} candidate hole(|s), each coordinate to {sigma:.4r units/length} "
     "({sigma_from})\n",
     kTipSigmaWords},
    {"parameters/reason", "no readings for the parameters: {}\n"},
    {"parameters/candidates",
     "readings for the parameters: {count} of {} candidate(|s), each coordinate to {sigma:.4r units/length} "
     "({sigma_from})\n",
     kForecastWords},
    {"next_readings", "{heading}\n", {}, {}, 1},
    {"next_readings", "  {id:<5} {for:<10} {kind:<8} ", kProposedWords}};

void addPlacing(const TouchProposal& proposal, nlohmann::json& figures) {
  figures["count"] = proposal.next.design.steps.size();
  figures["is_placed"] = isPlaced(proposal.next);
}

void appendRows(const TouchOutcome& outcome, const TouchProposal& proposal, char letter,
                std::vector<ProposedMeasurement>& sheet) {
  for (auto& named : nameMeasurements(outcome, proposal, letter)) sheet.push_back(std::move(named.measurement));
}

}  // namespace

nlohmann::json proposalsJson(const TouchOutcome& outcome) {
  const Units& units = outcome.cell.units;
  nlohmann::json json = {{"next_readings", nlohmann::json::array()},
                         {"work", {{"postures", outcome.work}, {"out_of_reach", outcome.work_lost}}},
                         {"notes", outcome.notes},
                         {"units", unitsJson(units)}};
  if (outcome.base) {
    appendMeasurements(outcome, *outcome.base, 'T', "base", json["next_readings"]);
    json["base"] = proposalJson(outcome, *outcome.base, outcome.base_noise);
    if (!outcome.nearest_holes.empty()) {
      json["base"]["nearest_holes"] = outcome.nearest_holes;
      json["base"]["tip_sigma"]["nearest"] = tipJson(outcome.tip_nearest, units);
    }
  }
  if (outcome.parameters) {
    appendMeasurements(outcome, *outcome.parameters, 'N', "parameters", json["next_readings"]);
    json["parameters"] = proposalJson(outcome, *outcome.parameters, outcome.noise);
  }
  return json;
}

std::string proposalsText(const TouchOutcome& outcome) {
  nlohmann::json figures = proposalsJson(outcome);
  if (outcome.base) addPlacing(*outcome.base, figures["base"]);
  if (outcome.parameters) addPlacing(*outcome.parameters, figures["parameters"]);
  std::string heading =
      fmt::format("  {:<5} {:<10} {:<8} {:<9} {:>8}", "", "for", "", "point", outcome.cell.units.force().name);
  for (const auto& joint : outcome.cell.arm.joints()) heading += fmt::format(" {:>9}", joint.name);
  figures["heading"] = heading + "   most informative about";
  return textOf(figures, kProposalWords);
}

std::vector<ProposedMeasurement> runSheetOf(const TouchOutcome& outcome) {
  std::vector<ProposedMeasurement> sheet;
  if (outcome.base) appendRows(outcome, *outcome.base, 'T', sheet);
  if (outcome.parameters) appendRows(outcome, *outcome.parameters, 'N', sheet);
  return sheet;
}

}  // namespace tubeplan::app
