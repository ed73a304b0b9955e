#include "app/documents/touch_proposals.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/figures.hpp"
#include "app/documents/fill_in_json.hpp"
#include "app/documents/identification_json.hpp"
#include "app/files/joint_units.hpp"
#include "app/files/units.hpp"
#include "app/files/units_json.hpp"
#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::app {

namespace {

using calibration::NumberForecast, calibration::ProposedMeasurement, calibration::TipSigma;

/// A proposed reading by its name, and the step of the design that chose it.
struct NamedReading {
  ProposedMeasurement reading;
  std::size_t step;
};

/// T1, T2, ... for the base, N1, N2, ... for the numbers; touches of one unknown point are N1a, N1b, ... of point N1.
std::vector<NamedReading> nameReadings(const TouchOutcome& outcome, const TouchProposal& proposal, char letter) {
  std::vector<NamedReading> named;
  for (std::size_t s = 0; s < proposal.next.design.steps.size(); ++s) {
    const auto& readings = proposal.chosen(proposal.next.design.steps[s]).readings;
    const std::string name = letter + std::to_string(s + 1);
    for (std::size_t k = 0; k < readings.size(); ++k) {
      ProposedMeasurement reading = readings[k];
      reading.id = readings.size() == 1 ? name : name + static_cast<char>('a' + k);
      if (touchesUnknownPoint(reading)) reading.point = name;
      reading.setup = outcome.setup;
      named.push_back({std::move(reading), s});
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

void appendReadings(const TouchOutcome& outcome, const TouchProposal& proposal, char letter, const char* goal,
                    nlohmann::json& list) {
  const Units& units = outcome.cell.units;
  for (const auto& [reading, chosen_in] : nameReadings(outcome, proposal, letter)) {
    const auto& step = proposal.next.design.steps[chosen_in];
    nlohmann::json json = {{"id", reading.id},
                           {"for", goal},
                           {"kind", calibration::kindOf(reading.kind).name},
                           {"joints", proposedJointsJson(outcome, reading.q)},
                           {"load", units.toFile(reading.load, dimension::kForce)},
                           {"fill_in", fillInJson(fillInOf(reading, outcome.cell.arm, units))},
                           {"adds",
                            {{"bits", finiteJson(step.bits)},
                             {"tip_sigma_then", tipJson(step.tip, units)},
                             {"helps", proposal.next.numbers[static_cast<std::size_t>(step.most_helped)].unknown.name},
                             {"its_sigma_times", finiteJson(step.helped_by)}}}};
    if (!reading.point.empty()) json["point"] = reading.point;
    if (reading.known_W) json["place"] = vectorJson(*reading.known_W, units, dimension::kLength);
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

nlohmann::json proposalJson(const TouchOutcome& outcome, const TouchProposal& proposal, const ReadingNoise& noise) {
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

std::string proposedJointsText(const TouchOutcome& outcome, const Eigen::VectorXd& q) {
  std::string text;
  for (const auto& figure : jointFigures(outcome.cell.arm, q, outcome.cell.units))
    text += fmt::format(" {:>9}", figure);
  return text;
}

/// What a reading is most informative about.
std::string informativeText(const TouchProposal& proposal, std::size_t index) {
  const auto& step = proposal.next.design.steps[index];
  const auto& name = proposal.next.numbers[static_cast<std::size_t>(step.most_helped)].unknown.name;
  return fmt::format("   {} (sigma x {:.2g})", name, step.helped_by);
}

std::string proposedText(const TouchOutcome& outcome, const TouchProposal& proposal, char letter) {
  const Units& units = outcome.cell.units;
  std::string joints, text;
  for (const auto& joint : outcome.cell.arm.joints()) joints += fmt::format(" {:>9}", joint.name);
  const bool names_numbers = letter == 'N';  // every reading is informative about the whole base
  text += fmt::format("  {:<5} {:<8} {:<9} {:>8}{}{}\n", "", "", "point", std::string(units.force().name), joints,
                      names_numbers ? "   most informative about" : "");
  std::size_t last_step = proposal.next.design.steps.size();
  for (const auto& [reading, step] : nameReadings(outcome, proposal, letter)) {
    text +=
        fmt::format("  {:<5} {:<8} {:<9} {:8.4g}{}", reading.id, calibration::kindOf(reading.kind).name, reading.point,
                    reading.load / units.factor(dimension::kForce), proposedJointsText(outcome, reading.q));
    if (names_numbers && step != last_step) text += informativeText(proposal, step);
    last_step = step;
    text += "\n";
  }
  return text;
}

std::string tipRow(const std::string& title, const TipSigma& sigma, const Units& units) {
  const double unit = units.factor(dimension::kLength);
  return fmt::format("  {:<44} {:>10.4g} {:>10.4g}\n", title, sigma.rms / unit, sigma.worst / unit);
}

/// Whether readings made so far place the base, or it is known.
bool isPlaced(const calibration::NextReadings& next) {
  return std::all_of(next.numbers.begin(), next.numbers.end(), [](const NumberForecast& number) {
    return number.unknown.owner == calibration::Unknown::Owner::kArm || number.is_identifiable_now;
  });
}

std::string tipText(const TouchOutcome& outcome, const TouchProposal& proposal) {
  const Units& units = outcome.cell.units;
  const std::size_t count = proposal.next.design.steps.size();
  std::string text = fmt::format(
      "  {:<44} {:>10} {:>10}\n",
      fmt::format("standard deviation of the tip at work, {} per coordinate", units.length().name), "rms", "worst");
  text += isPlaced(proposal.next) ? tipRow("now", proposal.next.tip_now, units)
                                  : fmt::format("  {:<44} {:>21}\n", "now", "base not calibrated yet");
  text += tipRow(fmt::format("after these {}", count), proposal.next.tip_after, units);
  text += tipRow(fmt::format("after {} random ones (median)", count), proposal.next.tip_random, units);
  return text;
}

std::string noiseText(const ReadingNoise& noise, const Units& units) {
  return fmt::format("each coordinate to {:.4g} {} ({})", noise.sigma / units.factor(dimension::kLength),
                     units.length().name, noise.from);
}

std::string baseText(const TouchOutcome& outcome) {
  const TouchProposal& proposal = *outcome.base;
  if (!proposal.reason.empty()) return "no touches for the base: " + proposal.reason + "\n";
  std::string text =
      fmt::format("touches for the base: {} of {} candidate holes, {}\n", proposal.next.design.steps.size(),
                  proposal.next.candidates.size(), noiseText(outcome.base_noise, outcome.cell.units));
  text += proposedText(outcome, proposal, 'T') + tipText(outcome, proposal);
  if (!outcome.nearest_holes.empty())
    text += tipRow(fmt::format("after the nearest, {}", fmt::join(outcome.nearest_holes, ", ")), outcome.tip_nearest,
                   outcome.cell.units);
  return text;
}

std::string shareText(double sigma, bool is_identifiable) {
  return is_identifiable ? fmt::format("{:.3g}", sigma) : "not identifiable";
}

std::string parametersText(const TouchOutcome& outcome) {
  const TouchProposal& proposal = *outcome.parameters;
  if (!proposal.reason.empty()) return "no readings for the parameters: " + proposal.reason + "\n";
  std::string text =
      fmt::format("readings for the parameters: {} of {} candidates, {}\n", proposal.next.design.steps.size(),
                  proposal.next.candidates.size(), noiseText(outcome.noise, outcome.cell.units));
  text += proposedText(outcome, proposal, 'N') + tipText(outcome, proposal);
  text += fmt::format("  {:<36} {:>12} {:>12} {:>12}\n", "sigma of the parameters", "now", "after", "after random");
  for (const auto& number : proposal.next.numbers) {
    const Dimension unit = dimensionOf(number.unknown.quantity);
    const double factor = outcome.cell.units.factor(unit);
    text +=
        fmt::format("  {:<36} {:>12} {:>12} {:>12} {}\n", number.unknown.name,
                    shareText(number.now / factor, number.is_identifiable_now),
                    shareText(number.after / factor, number.is_identifiable_after),
                    shareText(number.random / factor, number.is_identifiable_random), outcome.cell.units.nameOf(unit));
  }
  return text;
}

void appendRows(const TouchOutcome& outcome, const TouchProposal& proposal, char letter,
                std::vector<ProposedMeasurement>& sheet) {
  for (auto& named : nameReadings(outcome, proposal, letter)) sheet.push_back(std::move(named.reading));
}

}  // namespace

nlohmann::json proposalsJson(const TouchOutcome& outcome) {
  const Units& units = outcome.cell.units;
  nlohmann::json json = {{"next_readings", nlohmann::json::array()},
                         {"work", {{"postures", outcome.work}, {"out_of_reach", outcome.work_lost}}},
                         {"notes", outcome.notes},
                         {"units", unitsJson(units)}};
  if (outcome.base) {
    appendReadings(outcome, *outcome.base, 'T', "base", json["next_readings"]);
    json["base"] = proposalJson(outcome, *outcome.base, outcome.base_noise);
    if (!outcome.nearest_holes.empty()) {
      json["base"]["nearest_holes"] = outcome.nearest_holes;
      json["base"]["tip_sigma"]["nearest"] = tipJson(outcome.tip_nearest, units);
    }
  }
  if (outcome.parameters) {
    appendReadings(outcome, *outcome.parameters, 'N', "parameters", json["next_readings"]);
    json["parameters"] = proposalJson(outcome, *outcome.parameters, outcome.noise);
  }
  return json;
}

std::string proposalsText(const TouchOutcome& outcome) {
  std::string text = fmt::format("{} postures at work{}\n", outcome.work,
                                 outcome.work_lost ? fmt::format(", {} tubes out of reach", outcome.work_lost) : "");
  for (const auto& note : outcome.notes) text += "  note: " + note + "\n";
  if (outcome.base) text += baseText(outcome);
  if (outcome.parameters) text += parametersText(outcome);
  return text;
}

std::vector<ProposedMeasurement> runSheetOf(const TouchOutcome& outcome) {
  std::vector<ProposedMeasurement> sheet;
  if (outcome.base) appendRows(outcome, *outcome.base, 'T', sheet);
  if (outcome.parameters) appendRows(outcome, *outcome.parameters, 'N', sheet);
  return sheet;
}

}  // namespace tubeplan::app
