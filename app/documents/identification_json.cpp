#include "app/documents/identification_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/error_figures.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/figures_text.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/documents/pose_json.hpp"
#include "app/formats/units_json.hpp"
#include "calibration/measurements/surfaces.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::app {

namespace {

using calibration::ErrorSize, calibration::Identification, calibration::IdentificationStatus,
    calibration::Identifiability, calibration::IdentifiedNumber, calibration::Unknown;

std::string identifiableText(const IdentifiedNumber& number) {
  if (number.identifiable == Identifiability::kYes) return "yes";
  if (number.identifiable == Identifiability::kNo) return "no";
  return fmt::format("with {}", fmt::join(number.with, " and "));
}

nlohmann::json sizeJson(const ErrorSize& size, const ErrorUnit& unit) {
  return {{"rms", errorJson(size.rms, unit)},
          {"mean", errorJson(size.mean, unit)},
          {"max", errorJson(size.max, unit)},
          {"readings", size.measurements}};
}

/// Returns the standard deviation of a prior in file units. For a stiffness, the prior is on the compliance, and its
/// standard deviation is relative to the initial value.
nlohmann::json priorJson(const Unknown& unknown, const Units& units) {
  const bool is_compliance = unknown.scale == Unknown::Scale::kCompliance;
  return {{"sigma", is_compliance ? finiteJson(unknown.prior_sigma * unknown.start)
                                  : finiteJson(unknown.prior_sigma / units.factor(dimensionOf(unknown.quantity)))},
          {"unit", is_compliance ? "1" : units.nameOf(dimensionOf(unknown.quantity))},
          {"of", is_compliance ? "compliance relative to its initial value" : "value"}};
}

nlohmann::json numberJson(const IdentifiedNumber& number, const Units& units) {
  const Dimension unit = dimensionOf(number.unknown.quantity);
  const double factor = units.factor(unit);
  nlohmann::json json = {{"name", number.unknown.name},
                         {"value", finiteJson(number.value / factor)},
                         {"sigma", finiteJson(number.sigma / factor)},
                         {"unit", units.nameOf(unit)},
                         {"start", finiteJson(number.unknown.start / factor)},
                         {"identifiable", identifiableText(number)},
                         {"prior", priorJson(number.unknown, units)},
                         {"prior_deviation", finiteJson(number.prior_deviation)},
                         {"interval", {finiteJson(number.lower / factor), finiteJson(number.upper / factor)}},
                         {"interval_by", !number.modes.empty() ? "modes"
                                         : number.is_profile   ? "profile"
                                                               : "sigma"}};
  for (const double value : number.modes) json["modes"].push_back(finiteJson(value / factor));
  if (number.is_at_bound) json["at_bound"] = true;
  if (!number.note.empty()) json["note"] = number.note;
  return json;
}

/// Returns the unit in which the errors of a fit are written.
ErrorUnit errorUnitOf(const Identification& result, const Units& units) {
  return errorUnitOf(result.after.are_angles || result.before.are_angles, units);
}

std::vector<calibration::Measurement> fittedMeasurements(const Identification& result,
                                                         const std::vector<calibration::Measurement>& measurements) {
  std::vector<calibration::Measurement> used;
  for (const int k : result.used) used.push_back(measurements.at(static_cast<std::size_t>(k)));
  return used;
}

/// Returns a plane's normal and its distance from the world origin along this normal, or a sphere's centre and radius.
nlohmann::json surfaceJson(const calibration::SettledSurface& settled, const Units& units) {
  const double length = units.factor(dimension::kLength);
  nlohmann::json json = {{"kind", settled.kind}, {"point", settled.point}, {"readings", settled.measurements}};
  if (settled.surface.radius > 0) {
    json["centre"] = vectorJson(settled.surface.p_W, units, dimension::kLength);
    json["radius"] = finiteJson(settled.surface.radius / length);
  } else {
    const auto& normal = settled.surface.direction_W;
    json["normal"] = {normal.x(), normal.y(), normal.z()};
    json["distance"] = finiteJson(normal.dot(settled.surface.p_W) / length);
  }
  json["rms"] = finiteJson(settled.rms / length);
  return json;
}

constexpr std::string_view kErrorSizeWords =
    "  {@:<34} rms {rms:>9.4g}  mean {mean:>9.4g}  worst {max:>9.4g} {error_unit}\n";

constexpr TextLine kNumberNote[] = {{"note", "      {}\n"}};
constexpr std::string_view kNumberWords =
    "  {name:<36} {value:>12.6g} {unit:<14} sigma {sigma:>9.3g}  95 % {interval:.6i}  start {start:.6g}  identifiable: "
    "{identifiable}\n";

constexpr TextLine kBaseWords[] = {{"setup", " of {:n}"},
                                   {"",
                                    ": position [{base/position:.6r}] {units/length}, rpy [{base/rpy:.5r}] "
                                    "{units/angle}\n"}};
constexpr TextLine kFoundBaseWords[] = {{"!known", "base", kBaseWords}};

constexpr TextLine kSurfaceWords[] = {{"radius", "centre [{centre:.6r}], radius {radius:.5r}"},
                                      {"!radius", "normal [{normal:.5r}], distance {distance:.6r}"},
                                      {"", " {units/length}; {readings} reading(|s) within {rms:.3r} (rms)\n"}};

constexpr TextLine kIdentificationWords[] = {
    {"", "errors of {errors/after/readings} reading(|s)\n"},
    {"errors/before/readings", kErrorSizeWords, {}, "as it stands"},
    {"errors/after_base/readings", kErrorSizeWords, {}, "with the base fitted"},
    {"errors/after/readings", kErrorSizeWords, {}, "identified"},
    {"errors/heldout_before/readings", kErrorSizeWords, {}, "held out, with the base fitted"},
    {"errors/heldout_after/readings", kErrorSizeWords, {}, "held out, identified"},
    {"", "  noise alone                        rms {rms/noise_floor:>9.4r}\n"},
    {"", "chi-square {chi2:.1f} for {degrees_of_freedom} degrees of freedom"},
    {"+degrees_of_freedom", " ({chi2_per_dof:.2f} each, p = {p_value:.3g})\n"},
    {"!+degrees_of_freedom", ": the fit cannot be tested\n"},
    {"+model_error",
     "lack of fit: the model error in each coordinate is {:.4r error_unit} beyond the stated noise (one standard "
     "deviation); standard deviations and intervals treat it as noise, and do not cover a shift of the numbers by a "
     "missing effect\n"},
    {"", "parameters\n"},
    {"parameters", kNumberWords, kNumberNote},
    {"bases", "", kFoundBaseWords},
    {"base_steps", kNumberWords, kNumberNote},
    {"surfaces", "  {kind} {point:n}: ", kSurfaceWords},
    {"dropped", "  dropped {}\n"},
    {"correlations", "  correlation {value:+.3f} of {a} and {b}\n"},
    {"outliers", "  outlier: reading {id:n} is off by {size:.4r error_unit} ({sigmas:.1f} sigmas)\n"},
    {"set_aside", kSetAsideWords, {}, {}, 1}};

}  // namespace

nlohmann::json identificationJson(const Identification& result,
                                  const std::vector<calibration::Measurement>& measurements, std::size_t set_aside,
                                  const Units& units) {
  nlohmann::json json = {{"status", statusName(result.status)}, {"reason", result.reason}, {"units", unitsJson(units)}};
  json["parameters"] = nlohmann::json::array();
  if (result.status == IdentificationStatus::kRefused) return json;
  for (const auto& number : result.numbers)
    if (number.unknown.owner == Unknown::Owner::kArm) json["parameters"].push_back(numberJson(number, units));
  json["bases"] = nlohmann::json::array();
  for (const auto& base_pose : result.fitted.base_poses)
    json["bases"].push_back(
        {{"setup", base_pose.setup}, {"known", base_pose.is_known}, {"base", poseJson(base_pose.X_WB, units)}});
  json["base_steps"] = nlohmann::json::array();
  for (const auto& number : result.numbers)
    if (number.unknown.owner == Unknown::Owner::kBase) json["base_steps"].push_back(numberJson(number, units));
  json["surfaces"] = nlohmann::json::array();
  for (const auto& surface : calibration::surfacesOf(result.fitted, fittedMeasurements(result, measurements)))
    json["surfaces"].push_back(surfaceJson(surface, units));
  const ErrorUnit unit = errorUnitOf(result, units);
  json["rms"] = {{"before", errorJson(result.before.rms, unit)},
                 {"after_base", errorJson(result.after_base.rms, unit)},
                 {"after", errorJson(result.after.rms, unit)},
                 {"heldout_before", errorJson(result.heldout_before.rms, unit)},
                 {"heldout_after", errorJson(result.heldout.rms, unit)},
                 {"noise_floor", errorJson(result.noise_floor, unit)}};
  json["errors"] = {{"before", sizeJson(result.before, unit)},
                    {"after_base", sizeJson(result.after_base, unit)},
                    {"after", sizeJson(result.after, unit)},
                    {"heldout_before", sizeJson(result.heldout_before, unit)},
                    {"heldout_after", sizeJson(result.heldout, unit)}};
  json["error_unit"] = unit.name;
  json["error_budget"] = errorBudgetJson(budgetOf(result), set_aside, units);
  json["chi2"] = finiteJson(result.chi2);
  json["degrees_of_freedom"] = result.degrees_of_freedom;
  json["chi2_per_dof"] = finiteJson(result.chi2 / std::max(1, result.degrees_of_freedom));
  json["p_value"] = finiteJson(result.p_value);
  json["model_error"] = errorJson(result.model_error, unit);
  json["dropped"] = result.dropped;
  json["correlations"] = nlohmann::json::array();
  for (const auto& pair : result.correlations)
    json["correlations"].push_back({{"a", pair.a}, {"b", pair.b}, {"value", finiteJson(pair.value)}});
  json["outliers"] = nlohmann::json::array();
  for (const auto& outlier : result.outliers)
    json["outliers"].push_back({{"id", measurements.at(static_cast<std::size_t>(outlier.measurement)).id},
                                {"size", errorJson(outlier.size, unit)},
                                {"sigmas", finiteJson(outlier.sigmas)}});
  json["singular_values"] = nlohmann::json::array();
  for (const double value : result.singular_values) json["singular_values"].push_back(finiteJson(value));
  json["solver"] = {{"iterations", result.iterations},
                    {"evaluations", result.evaluations},
                    {"jacobian_evaluations", result.jacobian_evaluations},
                    {"starts_agreeing", result.starts_agreeing}};
  return json;
}

std::string identificationText(const nlohmann::json& figures) {
  if (!figures.contains("errors")) return textOf(figures, "not identified: {reason}\n");
  const bool is_converged = figures["status"] != statusName(IdentificationStatus::kNotConverged);
  return (is_converged ? "" : textOf(figures, "NOT CONVERGED: {reason}\n")) + textOf(figures, kIdentificationWords);
}

}  // namespace tubeplan::app
