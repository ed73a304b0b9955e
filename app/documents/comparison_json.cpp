#include "app/documents/comparison_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/diagnosis_views_json.hpp"
#include "app/documents/error_figures.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/figures_text.hpp"
#include "app/documents/identification_json.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/documents/pattern_json.hpp"
#include "app/formats/arm/joint_units.hpp"
#include "app/formats/units_json.hpp"
#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::app {

namespace {

using calibration::Adequacy, calibration::ComparedMeasurement, calibration::Comparison, calibration::ComparisonStatus,
    calibration::JointEquivalents, calibration::Measurement, calibration::ModelLackOfFit, calibration::Repeats;
using nlohmann::json;

constexpr std::size_t kWorstShown = 10;

json repeatsJson(const Repeats& repeats) {
  return {{"groups", repeats.groups},
          {"readings", repeats.measurements},
          {"pure_error_chi2", finiteJson(repeats.pure_error)},
          {"degrees_of_freedom", repeats.pure_freedom},
          {"noise_over_stated", finiteJson(repeats.noise_ratio)},
          {"noise_p_value", finiteJson(repeats.noise_p_value)},
          {"lack_of_fit",
           {{"F", finiteJson(repeats.lack_of_fit_F)},
            {"degrees_of_freedom", repeats.lack_freedom},
            {"p_value", finiteJson(repeats.lack_of_fit_p_value)}}}};
}

/// Returns the unit in which the errors of a comparison are written.
ErrorUnit errorUnitOf(const Comparison& result, const Units& units) {
  return errorUnitOf(result.after_refit.errors.are_angles || result.as_it_stands.errors.are_angles, units);
}

json lackOfFitJson(const ModelLackOfFit& lack_of_fit, const ErrorUnit& unit) {
  return {{"rms", errorJson(lack_of_fit.errors.rms, unit)},
          {"mean", errorJson(lack_of_fit.errors.mean, unit)},
          {"worst", errorJson(lack_of_fit.errors.max, unit)},
          {"readings", lack_of_fit.errors.measurements},
          {"noise_floor", errorJson(lack_of_fit.noise_floor, unit)},
          {"chi2", finiteJson(lack_of_fit.chi2)},
          {"degrees_of_freedom", lack_of_fit.degrees_of_freedom},
          {"chi2_per_dof", finiteJson(lack_of_fit.chi2 / std::max(1, lack_of_fit.degrees_of_freedom))},
          {"p_value", finiteJson(lack_of_fit.p_value)},
          {"verdict", nameOf(lack_of_fit.adequacy)},
          {"repeats", lack_of_fit.repeats.groups > 0 ? repeatsJson(lack_of_fit.repeats) : json()}};
}

json equivalentsJson(const Comparison& result, const JointEquivalents& joints, const Units& units) {
  if (!joints.ok) return nullptr;
  json list = json::array();
  for (Eigen::Index j = 0; j < result.fitted.arm.jointCount(); ++j) {
    const auto& joint = result.fitted.arm.joint(j);
    const double factor = units.factor(jointDimension(joint));
    list.push_back({{"joint", joint.name},
                    {"mean", finiteJson(joints.mean[j] / factor)},
                    {"spread", finiteJson(joints.spread[j] / factor)},
                    {"encoder_sigma", finiteJson(joints.sigma[j] / factor)},
                    {"unit", units.nameOf(jointDimension(joint))}});
  }
  return {{"joints", list},
          {"chi2", finiteJson(joints.chi2)},
          {"degrees_of_freedom", joints.degrees_of_freedom},
          {"p_value", finiteJson(joints.p_value)}};
}

json comparedJointsJson(const Eigen::VectorXd& q, const deflection::Arm& arm, const Units& units) {
  const Eigen::VectorXd factors = jointFactors(arm, units);
  json list = json::array();
  for (Eigen::Index j = 0; j < q.size(); ++j) list.push_back(finiteJson(q[j] / factors[j]));
  return list;
}

json comparedMeasurementJson(const ComparedMeasurement& compared, const Measurement& measurement,
                             const Comparison& result, const Units& units) {
  json entry = {{"id", measurement.id},
                {"kind", calibration::kindOf(measurement).name},
                {"point", measurement.point},
                {"setup", measurement.setup},
                {"load", finiteJson(measurement.load / units.factor(dimension::kForce))},
                {"joints", comparedJointsJson(measurement.q, result.fitted.arm, units)},
                {"senses", measurement.approach_directions},
                {"sigma", lengthJson(measurement.sigma, units)},
                {"held_out", compared.is_held_out},
                {"measured", measurement.p_W ? placeJson(*measurement.p_W, units) : json()},
                {"position_before", placeJson(compared.tip_before, units)},
                {"position_after", placeJson(compared.tip_after, units)},
                {"error_before", placeJson(compared.error_before, units)},
                {"error_after", placeJson(compared.error_after, units)},
                {"size_before", errorSizeJson(measurement, compared.error_before, compared.turn_before, units)},
                {"size_after", errorSizeJson(measurement, compared.error_after, compared.turn_after, units)},
                {"size_unit", errorUnitOf(measurement, units).name},
                {"sigmas_before", finiteJson(compared.sigmas_before)},
                {"sigmas_after", finiteJson(compared.sigmas_after)}};
  for (const auto& kind : deflection::kConditionKinds)
    entry[kind.name] = finiteJson(units.toFile(measurement.conditions[kind.condition], kind.unit));
  addOwnNumbers(measurement, units, entry);
  if (measurement.wrench) {
    entry["force"] = vectorJson(measurement.wrench->force_W, units, dimension::kForce);
    entry["moment"] = vectorJson(measurement.wrench->moment_W, units, dimension::kTorque);
  }
  return entry;
}

json comparedMeasurementsJson(const Comparison& result, const std::vector<Measurement>& measurements,
                              const Units& units) {
  json list = json::array();
  for (std::size_t k = 0; k < measurements.size(); ++k)
    list.push_back(comparedMeasurementJson(result.measurements.at(k), measurements[k], result, units));
  if (result.joints_after.ok)
    for (std::size_t i = 0; i < result.used.size(); ++i)
      list[static_cast<std::size_t>(result.used[i])]["joint_corrections"] = comparedJointsJson(
          result.joints_after.corrections.col(static_cast<Eigen::Index>(i)), result.fitted.arm, units);
  return list;
}

json worstJson(const Comparison& result, const std::vector<Measurement>& measurements, const Units& units) {
  json list = json::array();
  for (std::size_t k = 0; k < std::min(kWorstShown, result.worst.size()); ++k) {
    const auto measurement = static_cast<std::size_t>(result.worst[k]);
    const auto& compared = result.measurements.at(measurement);
    list.push_back(
        {{"id", measurements.at(measurement).id},
         {"error", placeJson(compared.error_after, units)},
         {"size", errorSizeJson(measurements.at(measurement), compared.error_after, compared.turn_after, units)},
         {"unit", errorUnitOf(measurements.at(measurement), units).name},
         {"sigmas", finiteJson(compared.sigmas_after)}});
  }
  return list;
}

std::string noiseSentence(const Comparison& result) {
  const auto& repeats = result.after_refit.repeats;
  if (repeats.groups == 0) return "No reading was repeated: the stated noise is used.";
  if (!result.noise_disagrees)
    return fmt::format("Repeated readings scatter {:.2f} times as much as stated, within what chance allows.",
                       repeats.noise_ratio);
  if (areBeyondNoise(repeats))
    return fmt::format(
        "Repeated readings scatter {:.3g} times as much as stated: this is too much for noise (up to {:.0f} times is "
        "accepted); a reading is wrong, or a change between them was not recorded.",
        repeats.noise_ratio, calibration::kMostNoiseRatio);
  return fmt::format(
      "The stated noise disagrees with the repeated readings: they scatter {:.2f} times as much ({}); lack of fit is "
      "judged by that scatter.",
      repeats.noise_ratio, chanceText(repeats.noise_p_value));
}

std::string errorClause(const Comparison& result, const Units& units) {
  const ErrorUnit unit = errorUnitOf(result, units);
  return fmt::format("the error is {} as it stands and {} after the refit; noise alone explains {}",
                     errorText(result.as_it_stands.errors.rms, unit, 3),
                     errorText(result.after_refit.errors.rms, unit, 3),
                     errorText(result.after_refit.noise_floor, unit, 3));
}

/// Returns a sentence on the error, followed by one sentence for each reason for the verdict.
std::vector<std::string> comparisonSentences(const Comparison& result, const Units& units) {
  std::vector<std::string> sentences = {errorClause(result, units)};
  sentences.insert(sentences.end(), result.grounds.begin(), result.grounds.end());
  for (auto& sentence : sentences) {
    sentence.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front())));
    sentence += '.';
  }
  return sentences;
}

constexpr TextLine kLackOfFitChance[] = {
    {"+degrees_of_freedom", "{p_value:p}"}, {"!+degrees_of_freedom", "no degree of freedom"}, {"", "): {verdict}\n"}};
constexpr std::string_view kLackOfFitWords =
    "  {@:<16} rms {rms:>10.3r error_unit}  mean {mean:>10.3r error_unit}  worst {worst:>10.3r error_unit}  chi-square "
    "per freedom {chi2_per_dof:.3r} (";
constexpr TextLine kCorrelationWords[] = {{"goes_with", " It correlates with {}."}, {"", "\n"}};

constexpr TextLine kComparisonWords[] = {
    {"", "{verdict}\n{sentence}\n"},
    {"reason", "  {}\n"},
    {"as_it_stands", kLackOfFitWords, kLackOfFitChance, "as it stands"},
    {"after_refit", kLackOfFitWords, kLackOfFitChance, "after the refit"},
    {"rms/heldout_after",
     "  held out: rms {rms/heldout_before:.3r error_unit} with only the base fitted, {:.3r error_unit} after the "
     "refit\n"},
    {"error_budget", "  {words}\n"},
    {"", "{noise}\n"},
    {"patterns", "  {sentence}", kCorrelationWords},
    {"", "  {#tested} patterns tested, {#patterns} found\n"},
    {"worst", "  worst: reading {id:n} is off by {size:.3r unit} ({sigmas:.1f} sigmas)\n", {}, {}, 3},
    {"joint_equivalents/after_refit/joints",
     "  as an error of {joint}: mean {mean:+.2g}, spread {spread:.2g} {unit}\n"},
    {"set_aside", kSetAsideWords, {}, {}, 1}};

}  // namespace

std::string comparisonSentence(const Comparison& result, const Units& units) {
  const std::string error = errorClause(result, units);
  if (result.verdict == Adequacy::kAdequate) return fmt::format("The model is adequate: {}.", error);
  if (result.verdict == Adequacy::kInconclusive)
    return noVerdictSentence(fmt::format("{}; {}", fmt::join(result.grounds, ", and "), error));
  return fmt::format("The model falls short, since {}: {}.", fmt::join(result.grounds, ", and "), error);
}

json comparisonJson(const Comparison& result, const std::vector<Measurement>& measurements, std::size_t set_aside,
                    const Units& units) {
  const auto& after = result.after_refit;
  const auto& refit = result.refit;
  const ErrorUnit unit = errorUnitOf(result, units);
  json report = {{"status", statusName(result.status)},
                 {"reason", result.reason},
                 {"units", measurementUnitsJson(units)},
                 {"verdict", nameOf(result.verdict)},
                 {"verdict_words", wordsOf(result.verdict)},
                 {"grounds", result.grounds},
                 {"sentence", comparisonSentence(result, units)},
                 {"sentences", comparisonSentences(result, units)},
                 {"noise", noiseSentence(result)},
                 {"chi2_per_dof", finiteJson(after.chi2 / std::max(1, after.degrees_of_freedom))},
                 {"p_value", finiteJson(after.p_value)},
                 {"as_it_stands", lackOfFitJson(result.as_it_stands, unit)},
                 {"after_refit", lackOfFitJson(after, unit)}};
  report["rms"] = {{"before", errorJson(result.as_it_stands.errors.rms, unit)},
                   {"after_base", errorJson(refit.after_base.rms, unit)},
                   {"after", errorJson(after.errors.rms, unit)},
                   {"noise_floor", errorJson(after.noise_floor, unit)},
                   {"heldout_before", errorJson(refit.heldout_before.rms, unit)},
                   {"heldout_after", errorJson(refit.heldout.rms, unit)}};
  report["error_unit"] = unit.name;
  report["error_budget"] = errorBudgetJson(budgetOf(result), set_aside, units);
  report["ladder"] = {
      {{"name", "as it stands"}, {"rms", report["rms"]["before"]}, {"heldout_rms", report["rms"]["heldout_before"]}},
      {{"name", "refitted"}, {"rms", report["rms"]["after"]}, {"heldout_rms", report["rms"]["heldout_after"]}}};
  report["refit"] = refit.status == calibration::IdentificationStatus::kNotRun
                        ? json()
                        : identificationJson(refit, measurements, set_aside, units);
  report["worst"] = worstJson(result, measurements, units);
  report["patterns"] = json::array();
  for (const auto& test : result.patterns.findings) report["patterns"].push_back(findingJson(test, units));
  report["tested"] = json::array();
  for (const auto& test : result.patterns.tests) report["tested"].push_back(testJson(test, units));
  report["not_tested"] = result.patterns.not_tested;
  report["errors"] = kErrorsAre;
  report["joint_equivalents"] = {{"as_it_stands", equivalentsJson(result, result.joints_before, units)},
                                 {"after_refit", equivalentsJson(result, result.joints_after, units)}};
  report["joint_columns"] = json::array();
  for (const auto& joint : result.fitted.arm.joints()) report["joint_columns"].push_back(jointColumn(joint, units));
  report["readings"] = comparedMeasurementsJson(result, measurements, units);
  return report;
}

std::string comparisonText(const json& figures) { return textOf(figures, kComparisonWords); }

}  // namespace tubeplan::app
