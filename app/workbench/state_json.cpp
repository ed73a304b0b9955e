#include "app/workbench/state_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "app/documents/diagnosis_views_json.hpp"
#include "app/documents/effect_words_json.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/documents/pose_json.hpp"
#include "app/formats/arm/joint_units.hpp"
#include "app/formats/units.hpp"
#include "app/formats/units_json.hpp"
#include "app/version.hpp"
#include "app/workbench/history.hpp"
#include "app/workbench/measurement_sets.hpp"
#include "app/workbench/project.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "deflection/effects/formula.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

/// Names of the results that have documents; each is null in the state until it is computed.
constexpr const char* kResults[] = {"compare", "diagnose", "identify", "ladder",  "plan",    "calibrate",
                                    "touches", "reach",    "field",    "improve", "simulate"};

json jointRangesJson(const Cell& cell) {
  json joints = json::array();
  for (const int row : deflection::activeRows(cell.arm)) {
    const auto& joint = cell.arm.rows[static_cast<std::size_t>(row)].joint;
    const Dimension unit = jointDimension(joint);
    const double home = std::clamp(0.0, joint.lower, joint.upper);
    joints.push_back({{"name", joint.name},
                      {"unit", cell.units.nameOf(unit)},
                      {"row", row},
                      {"lower", std::isfinite(joint.lower) ? json(cell.units.toFile(joint.lower, unit)) : json()},
                      {"upper", std::isfinite(joint.upper) ? json(cell.units.toFile(joint.upper, unit)) : json()},
                      {"home", cell.units.toFile(home, unit)}});
  }
  return joints;
}

json loadsJson(const Session& session, const Units& units) {
  std::set<double> loads;
  if (session.measurements)
    for (const auto& measurement : session.measurements->measurements)
      loads.insert(units.toFile(measurement.load, dimension::kForce));
  return loads;
}

json cellJson(const Session& session) {
  const Cell& cell = session.models.front()->cell;
  return {{"name", cell.name},
          {"file", std::filesystem::path(cell.path).filename().string()},
          {"units", measurementUnitsJson(cell.units)},
          {"file_units", {{"length", cell.units.length().name}, {"angle", cell.units.angle().name}}},
          {"base_known", cell.base_known},
          {"has_sheet", cell.sheet.has_value()},
          {"has_scene", !cell.scene.obstacles.empty() || !cell.scene.bodies.empty()},
          {"has_tool", cell.tool.has_value()},
          {"has_truth", !session.truth.empty()},
          {"has_park", cell.park.has_value()},
          {"park", cell.park ? json(jointValuesJson(*cell.park, cell)) : json()},
          {"has_arm_file", !cell.arm_source.text.empty()},
          {"joints", jointRangesJson(cell)},
          {"identify", cell.identify},
          {"loads", loadsJson(session, cell.units)}};
}

json effectJson(const deflection::Arm& arm, const deflection::Effect& effect, const Units& units) {
  json parameters = json::object();
  const auto& numbers = deflection::numbersOf(effect);
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    const auto quantity = deflection::numberOf(arm, effect, static_cast<int>(v)).quantity;
    parameters[numbers[v].name] = {{"value", units.toFile(effect.values[v], dimensionOf(quantity))},
                                   {"unit", units.nameOf(dimensionOf(quantity))}};
  }
  json entry = {{"effect", deflection::effectKinds().at(static_cast<std::size_t>(effect.kind)).name},
                {"at", deflection::placeText(arm, effect)},
                {"parameters", parameters}};
  if (effect.formula) entry["formula"] = effect.formula->text;
  addEffectWords(entry["effect"], entry);
  return entry;
}

json modelsJson(const Session& session) {
  json models = json::array();
  for (const auto& model : session.models) {
    json effects = json::array();
    for (const auto& effect : model->cell.arm.effects)
      effects.push_back(effectJson(model->cell.arm, effect, model->cell.units));
    models.push_back({{"id", model->id},
                      {"label", model->label},
                      {"origin", model->origin},
                      {"base", standingJson(standingOf(model->cell))},
                      {"effects", effects},
                      {"free", model->cell.identify}});
  }
  return models;
}

json measurementSummaryJson(const Session& session) {
  if (!session.measurements) return nullptr;
  std::map<std::string, int> kinds;
  std::set<std::string> setups;
  double sigma = std::numeric_limits<double>::quiet_NaN();
  for (const auto& measurement : session.measurements->measurements) {
    ++kinds[calibration::kindOf(measurement).name];
    setups.insert(measurement.setup);
    if (!(sigma >= measurement.sigma)) sigma = measurement.sigma;
  }
  json document = {
      {"name", session.measurements->name},
      {"readings", session.measurements->measurements.size()},
      {"kinds", kinds},
      {"setups", setups.size()},
      {"set_aside", session.measurements->set_aside.size()},
      {"held_out", std::count_if(session.measurements->measurements.begin(), session.measurements->measurements.end(),
                                 [](const auto& measurement) { return measurement.is_held_out; })},
      {"change", session.measurements->change},
      {"joined", joinedCount(*session.measurements)},
      {"assumed", assumedOf(*session.measurements)},
      {"sigma", lengthOf(sigma, currentModel(session).cell.units)}};
  addChecks(session.measurements->checks, currentModel(session).cell.units, document);
  return document;
}

json resultsJson(const Session& session) {
  json results = json::object();
  for (const char* name : kResults) {
    const auto result = findResult(session, name);
    results[name] = result ? json{{"model", result->model}, {"revision", result->revision}} : json();
    if (result)
      for (const auto& [model, own] : session.results.at(name)) results[name]["models"].push_back(model);
  }
  return results;
}

}  // namespace

json stateJson(const Workbench& workbench) {
  const auto moment = workbench.events().moment();  // read before the state, see Events::moment()
  const Session session = workbench.session();
  return {{"revision", session.revision},
          {"moment", moment},
          {"version", kVersion},
          {"folder", workbench.folder().path().string()},
          {"unit_table", unitTableJson()},
          {"cell", cellJson(session)},
          {"models", modelsJson(session)},
          {"model", currentModel(session).id},
          {"can_undo", !undoWords(session).empty()},
          {"can_redo", !redoWords(session).empty()},
          {"undo_words", undoWords(session)},
          {"redo_words", redoWords(session)},
          {"measurements", measurementSummaryJson(session)},
          {"results", resultsJson(session)},
          {"touches", session.touches.size()},
          {"project",
           {{"file", session.project.empty() ? json() : json(session.project)},
            {"unsaved", isUnsaved(session)},
            {"kept", !workbench.keeper().file().empty() && workbench.keeper().problem().empty()},
            {"problem", workbench.keeper().problem()}}},
          {"jobs", workbench.jobs().list()}};
}

json measurementsJson(const Model& model, const MeasurementSet& set) {
  const Cell& cell = model.cell;
  json rows = json::array();
  for (const auto& measurement : set.measurements) {
    json row = measurementJson(measurement, cell.arm, cell.units);
    row["line"] = measurement.line;
    row["sigma"] = lengthOf(measurement.sigma, cell.units);
    row["held_out"] = measurement.is_held_out;
    row["set_aside"] = set.set_aside.contains(measurement.id);
    row["position"] = measurement.p_W ? vectorJson(*measurement.p_W, cell.units, dimension::kLength) : json();
    const auto shape =
        deflection::solveFlexibleKinematics(cell.arm, calibration::postureOf(measurement, cell.arm, cell.X_WB));
    row["tip"] = shape.status == deflection::KinematicsStatus::kConverged
                     ? vectorJson(cell.X_WB * shape.X_BD.p, cell.units, dimension::kLength)
                     : json();
    rows.push_back(std::move(row));
  }
  return {{"name", set.name},
          {"units", measurementUnitsJson(cell.units)},
          {"joints", jointsJson(cell.arm, cell.units)},
          {"rows", rows}};
}

}  // namespace tubeplan::app
