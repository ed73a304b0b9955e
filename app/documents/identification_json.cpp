#include "app/documents/identification_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/error_figures.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/pose_json.hpp"
#include "app/files/input_error.hpp"
#include "app/files/units_json.hpp"
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
          {"readings", size.readings}};
}

/// A prior's sigma in the file's units; of a stiffness, whose compliance has it, as a share of the value.
nlohmann::json priorJson(const Unknown& unknown, const Units& units) {
  const bool is_compliance = unknown.scale == Unknown::Scale::kCompliance;
  return {{"sigma", is_compliance ? finiteJson(unknown.prior_sigma * unknown.start)
                                  : finiteJson(unknown.prior_sigma / units.factor(dimensionOf(unknown.quantity)))},
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

std::string errorFigure(double error, const ErrorUnit& unit) {
  return std::isfinite(error) ? fmt::format("{:.4g}", error / unit.factor) : "none";
}

/// The unit that the errors of a fit are in.
ErrorUnit errorUnitOf(const Identification& result, const Units& units) {
  return errorUnitOf(result.after.are_angles || result.before.are_angles, units);
}

/// Open where there is no end: a stiffness that may be rigid.
std::string intervalText(double lower, double upper) {
  if (std::isfinite(lower) && std::isfinite(upper)) return fmt::format("95 % {:.6g} to {:.6g}", lower, upper);
  if (std::isfinite(lower)) return fmt::format("95 % {:.6g} or more", lower);
  return std::isfinite(upper) ? fmt::format("95 % {:.6g} or less", upper) : "95 % anything";
}

std::string sizeText(const char* title, const ErrorSize& size, const ErrorUnit& unit) {
  if (size.readings == 0) return "";
  return fmt::format("  {:<34} rms {:>9}  mean {:>9}  worst {:>9} {}\n", title, errorFigure(size.rms, unit),
                     errorFigure(size.mean, unit), errorFigure(size.max, unit), unit.name);
}

std::string numberText(const IdentifiedNumber& number, const Units& units) {
  const Dimension unit = dimensionOf(number.unknown.quantity);
  const double factor = units.factor(unit);
  std::string text = fmt::format("  {:<36} {:>12.6g}", number.unknown.name, number.value / factor);
  text += fmt::format(" {:<14} sigma {:>9}  {}", units.nameOf(unit),
                      std::isfinite(number.sigma) ? fmt::format("{:.3g}", number.sigma / factor) : "none",
                      intervalText(number.lower / factor, number.upper / factor));
  text += fmt::format("  start {:.6g}  identifiable: {}\n", number.unknown.start / factor, identifiableText(number));
  if (!number.note.empty()) text += "      " + number.note + "\n";
  return text;
}

std::string baseText(const calibration::BasePose& base, const Units& units) {
  const Eigen::Vector3d at = base.X_WB.translation() / units.factor(dimension::kLength);
  const Eigen::Vector3d rpy = deflection::fixedAnglesOf(base.X_WB.linear()) / units.factor(dimension::kAngle);
  return fmt::format("base{}: position [{:.6g}, {:.6g}, {:.6g}] {}, rpy [{:.5g}, {:.5g}, {:.5g}] {}\n",
                     base.setup.empty() ? "" : " of " + nameInLine(base.setup), at.x(), at.y(), at.z(),
                     units.length().name, rpy.x(), rpy.y(), rpy.z(), units.angle().name);
}

std::vector<calibration::Measurement> fittedReadings(const Identification& result,
                                                     const std::vector<calibration::Measurement>& readings) {
  std::vector<calibration::Measurement> used;
  for (const int k : result.used) used.push_back(readings.at(static_cast<std::size_t>(k)));
  return used;
}

/// Of a plane its normal and its distance from the world's origin along that, of a sphere its centre and radius.
nlohmann::json surfaceJson(const calibration::SettledSurface& settled, const Units& units) {
  const double length = units.factor(dimension::kLength);
  nlohmann::json json = {{"kind", settled.kind}, {"point", settled.point}, {"readings", settled.readings}};
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

std::string surfaceText(const calibration::SettledSurface& settled, const Units& units) {
  const double length = units.factor(dimension::kLength);
  const auto& [p_W, normal, radius] = settled.surface;
  const std::string where = radius > 0
                                ? fmt::format("centre [{:.6g}, {:.6g}, {:.6g}] {}, radius {:.5g}", p_W.x() / length,
                                              p_W.y() / length, p_W.z() / length, units.length().name, radius / length)
                                : fmt::format("normal [{:.5g}, {:.5g}, {:.5g}], distance {:.6g} {}", normal.x(),
                                              normal.y(), normal.z(), normal.dot(p_W) / length, units.length().name);
  return fmt::format("  {} {}: {}; {} readings within {:.3g} (rms)\n", settled.kind, nameInLine(settled.point), where,
                     settled.readings, settled.rms / length);
}

}  // namespace

nlohmann::json identificationJson(const Identification& result, const std::vector<calibration::Measurement>& readings,
                                  std::size_t set_aside, const Units& units) {
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
  for (const auto& surface : calibration::surfacesOf(result.fitted, fittedReadings(result, readings)))
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
    json["outliers"].push_back({{"id", readings.at(static_cast<std::size_t>(outlier.reading)).id},
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

std::string identificationText(const Identification& result, const std::vector<calibration::Measurement>& readings,
                               const Units& units) {
  if (result.status == IdentificationStatus::kRefused) return "not identified: " + result.reason + "\n";
  const ErrorUnit unit = errorUnitOf(result, units);
  std::string text;
  if (result.status == IdentificationStatus::kNotConverged) text = "NOT CONVERGED: " + result.reason + "\n";
  text += fmt::format("errors of {} readings\n", result.used.size());
  text += sizeText("as it stands", result.before, unit);
  text += sizeText("with the base fitted", result.after_base, unit);
  text += sizeText("identified", result.after, unit);
  text += sizeText("held out, with the base fitted", result.heldout_before, unit);
  text += sizeText("held out, identified", result.heldout, unit);
  if (result.numbers.empty()) return text;
  text += fmt::format("  {:<34} rms {:>9}\n", "noise alone", errorFigure(result.noise_floor, unit));
  text += fmt::format("chi-square {:.1f} for {} degrees of freedom", result.chi2, result.degrees_of_freedom);
  text += result.degrees_of_freedom > 0
              ? fmt::format(" ({:.2f} each, p = {:.3g})\n", result.chi2 / result.degrees_of_freedom, result.p_value)
              : std::string(": the fit cannot be tested\n");
  if (result.model_error > 0)
    text += fmt::format(
        "lack of fit: the model error is {} {} in each coordinate beyond the stated noise (one standard deviation); "
        "standard deviations and intervals count it as noise, not as what a missing effect shifts the numbers by\n",
        errorFigure(result.model_error, unit), unit.name);
  text += "parameters\n";
  for (const auto& number : result.numbers)
    if (number.unknown.owner == Unknown::Owner::kArm) text += numberText(number, units);
  for (const auto& base : result.fitted.base_poses)
    if (!base.is_known) text += baseText(base, units);
  for (const auto& number : result.numbers)
    if (number.unknown.owner == Unknown::Owner::kBase) text += numberText(number, units);
  for (const auto& surface : calibration::surfacesOf(result.fitted, fittedReadings(result, readings)))
    text += surfaceText(surface, units);
  for (const auto& dropped : result.dropped) text += "  dropped " + dropped + "\n";
  for (const auto& pair : result.correlations)
    text += fmt::format("  correlation {:+.3f} of {} and {}\n", pair.value, pair.a, pair.b);
  for (const auto& outlier : result.outliers)
    text += fmt::format("  outlier: reading {} is off by {} {} ({:.1f} sigmas)\n",
                        nameInLine(readings.at(static_cast<std::size_t>(outlier.reading)).id),
                        errorFigure(outlier.size, unit), unit.name, outlier.sigmas);
  return text;
}

}  // namespace tubeplan::app
