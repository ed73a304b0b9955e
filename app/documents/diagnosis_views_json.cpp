#include "app/documents/diagnosis_views_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>

#include "app/documents/diagnosis_sentences.hpp"
#include "app/documents/error_figures.hpp"
#include "app/documents/model_comparison_json.hpp"
#include "app/formats/arm/joint_units.hpp"
#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::app {

namespace {

using calibration::AddedVariable, calibration::Diagnosis, calibration::Explanation, calibration::Measurement,
    calibration::MeasurementView;
using nlohmann::json;

/// Returns a value rounded to six significant digits, which suffice for plots and keep the JSON of many measurements
/// small; null if not finite.
json brief(double value) {
  return std::isfinite(value) ? json(std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr)) : json();
}

json briefLength(double metres, const Units& units) { return brief(metres / units.factor(dimension::kLength)); }

json briefPlace(const Eigen::Vector3d& p, const Units& units) {
  return {briefLength(p.x(), units), briefLength(p.y(), units), briefLength(p.z(), units)};
}

json viewJson(const MeasurementView& view, const Measurement& measurement, const deflection::Arm& arm,
              const Units& units) {
  json entry = measurementJson(measurement, arm, units);
  entry["position"] = briefPlace(view.p_WT, units);
  entry["before"] = briefPlace(view.before, units);
  entry["explained"] = json::array();
  for (const auto& error : view.after) entry["explained"].push_back(briefPlace(error, units));
  entry["after"] = view.after.empty() ? json() : entry["explained"].front();
  entry["size_before"] = errorSizeJson(measurement, view.before, view.turn_before, units);
  entry["size_explained"] = json::array();
  for (std::size_t k = 0; k < view.after.size(); ++k)
    entry["size_explained"].push_back(errorSizeJson(measurement, view.after[k], view.turn_after[k], units));
  entry["size_unit"] = errorUnitOf(measurement, units).name;
  return entry;
}

json addedJson(const AddedVariable& added, const Explanation& explanation, const std::map<int, int>& listed) {
  const auto& effect = explanation.effects.at(static_cast<std::size_t>(added.effect));
  json points = json::array();
  for (const auto& point : added.points)
    points.push_back({listed.at(point.measurement), brief(point.signature), brief(point.residual)});
  return {{"explanation", added.explanation},
          {"effect", effect.effect},
          {"at", effect.at},
          {"slope", brief(added.slope)},
          {"length", brief(added.length)},
          {"kept_fraction", brief(added.kept_fraction)},
          {"points", points}};
}

}  // namespace

json jointsJson(const deflection::Arm& arm, const Units& units) {
  json joints = json::array();
  for (const auto& row : arm.rows)
    if (row.joint.type != deflection::JointType::kPassive)
      joints.push_back(
          {{"name", row.joint.name}, {"unit", units.nameOf(jointDimension(row.joint))}, {"row", row.name}});
  return joints;
}

void addOwnNumbers(const Measurement& measurement, const Units& units, json& entry) {
  for (const auto& [name, quantity] : calibration::kindOf(measurement).columns)
    if (const double value = calibration::ownNumber(measurement, name); std::isfinite(value))
      entry[name] = brief(units.toFile(value, dimensionOf(quantity)));
}

json measurementJson(const Measurement& measurement, const deflection::Arm& arm, const Units& units) {
  json entry = {{"id", measurement.id},
                {"kind", calibration::kindOf(measurement).name},
                {"point", measurement.point},
                {"joints", json::array()},
                {"load", brief(measurement.load / units.factor(dimension::kForce))}};
  const Eigen::VectorXd joints = measurement.q.cwiseQuotient(jointFactors(arm, units));
  for (const double value : joints) entry["joints"].push_back(brief(value));
  addOwnNumbers(measurement, units, entry);
  if (measurement.row) entry["row"] = arm.rows.at(static_cast<std::size_t>(*measurement.row)).name;
  if (!measurement.setup.empty()) entry["setup"] = measurement.setup;
  if (!measurement.approach_directions.empty()) entry["senses"] = measurement.approach_directions;
  for (const auto& kind : deflection::kConditionKinds)
    if (measurement.conditions.states(kind.condition))
      entry[kind.name] = brief(units.toFile(measurement.conditions[kind.condition], kind.unit));
  return entry;
}

json modelComparisonJson(const Diagnosis& result, const Units& units) {
  const ErrorUnit unit = errorUnitOf(result.before.are_angles, units);
  const auto row = [&](const std::string& name, double rms, double heldout) {
    return json{{"name", name}, {"rms", brief(rms / unit.factor)}, {"heldout_rms", brief(heldout / unit.factor)}};
  };
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto& base_poses = result.baseline.fitted.base_poses;
  const bool is_placed =
      std::all_of(base_poses.begin(), base_poses.end(), [](const auto& base_pose) { return base_pose.is_known; });
  json ladder = {is_placed ? row("as it stands", result.baseline.before.rms, kNone)
                           : row("unchanged, with only its base fitted", result.baseline.after_base.rms, kNone),
                 row("refitted", result.before.rms, result.heldout_before.rms)};
  for (const auto& explanation : calibration::explanationsShown(result))
    ladder.push_back(row("with " + namesText(explanation), explanation.after.rms, explanation.heldout.rms));
  return ladder;
}

void addViews(const Diagnosis& result, const std::vector<Measurement>& measurements, const Units& units, json& target) {
  const deflection::Arm& arm = result.baseline.fitted.arm;
  const auto shown = calibration::explanationsShown(result);
  target["joints"] = jointsJson(arm, units);
  target["ladder"] = modelComparisonJson(result, units);
  target["readings"] = json::array();
  std::map<int, int> listed;
  for (const auto& view : result.views.measurements) {
    listed.emplace(view.measurement, static_cast<int>(listed.size()));
    target["readings"].push_back(
        viewJson(view, measurements.at(static_cast<std::size_t>(view.measurement)), arm, units));
  }
  target["added_variable"] = json::array();
  for (const auto& added : result.views.added)
    target["added_variable"].push_back(addedJson(added, shown.at(static_cast<std::size_t>(added.explanation)), listed));
}

}  // namespace tubeplan::app
