#include "app/workbench/project_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "app/documents/ladder_json.hpp"
#include "app/formats/cell/cell_writer.hpp"
#include "app/formats/measurements/measurements_writer.hpp"
#include "app/formats/units_json.hpp"
#include "app/storage/commit.hpp"
#include "app/storage/sha256.hpp"
#include "app/studies/positioning/base_standing.hpp"
#include "app/version.hpp"
#include "app/workbench/project.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

std::string usedMeasurementsText(const Session& session) {
  const Cell& cell = session.models.front()->cell;
  return measurementsCsv(measurementsInUse(*session.measurements), cell.arm, cell.units);
}

std::string modelFile(std::size_t index) { return fmt::format("model-{}.yaml", index); }

json inputJson(const std::string& what, const std::string& name, const std::string& text) {
  return {{"what", what}, {"name", name}, {"bytes", text.size()}, {"sha256", sha256Of(text)}};
}

/// Returns the inputs with the checksums of the files of projectFiles(), as `sha256sum` computes them.
json inputsJson(const Session& session) {
  json inputs = json::array();
  const auto of_cell = cellFiles(session.models.front()->cell, modelFile(0));
  for (const auto& file : of_cell)
    inputs.push_back(inputJson(&file == &of_cell.front() ? "cell as given" : "its arm", file.path.string(), file.text));
  if (session.measurements)
    inputs.push_back(inputJson("readings in use, of " + session.measurements->name, "measurements.csv",
                               usedMeasurementsText(session)));
  return inputs;
}

/// Returns the results of the comparison of a model; empty if the model was not compared.
json figuresOf(const Session& session, int model) {
  const auto compared = findResult(session, "compare", model);
  if (!compared) return json::object();
  const json& document = compared->document;
  return {{"rms", document["rms"]["after"]},
          {"heldout_rms", document["rms"]["heldout_after"]},
          {"chi2_per_dof", document["chi2_per_dof"]},
          {"p_value", document["p_value"]},
          {"verdict", document["verdict"]}};
}

json historyJson(const Session& session) {
  json history = json::array();
  for (std::size_t k = 0; k < session.models.size(); ++k) {
    const Model& model = *session.models[k];
    json entry = figuresOf(session, model.id);
    entry["name"] = model.label;
    entry["origin"] = model.origin;
    entry["file"] = modelFile(k);
    entry["state"] = k == session.current ? "current" : k > session.current ? "undone" : "";
    history.push_back(std::move(entry));
  }
  return history;
}

json modelsOfLadder(const Session& session) {
  const auto ladder = findResult(session, "ladder");
  return ladder ? ladderModels(ladder->document["models"]) : json::array();
}

/// Returns the path as a single shell word, quoted if necessary.
std::string inShell(const std::filesystem::path& path) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./+:@,";
  const std::string word = path.string();
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char letter : word) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
}

/// Returns the command lines that reproduce the results from the files of projectFiles(), in order of execution.
json commandsJson(const Session& session, const ProjectReportRequest& request) {
  const auto in = [&](const std::string& name) { return inShell(std::filesystem::path(request.files) / name); };
  json commands = {fmt::format("tubeplan report {} --files {}", inShell(request.project), inShell(request.files))};
  if (!session.measurements) return commands;
  std::string stack;
  for (std::size_t k = 0; k <= session.current; ++k) {
    stack += " " + in(modelFile(k));
    if (findResult(session, "compare", session.models[k]->id))
      commands.push_back(fmt::format("tubeplan compare {} {}", in(modelFile(k)), in("measurements.csv")));
    if (findResult(session, "diagnose", session.models[k]->id))
      commands.push_back(fmt::format("tubeplan diagnose {} {}", in(modelFile(k)), in("measurements.csv")));
  }
  if (findResult(session, "ladder"))
    commands.push_back(fmt::format("tubeplan ladder {}{} --rigid", in("measurements.csv"), stack));
  return commands;
}

/// Returns the facts of the report as [[name, value], ...].
json factsJson(const Session& session, const ProjectReportRequest& request) {
  const auto fact = [](const std::string& name, const std::string& value) { return json::array({name, value}); };
  json facts = json::array({fact("Report made", request.made),
                            fact("Project saved", projectSummary(request.project).value("saved", "")),
                            fact("Program", fmt::format("tubeplan {} ({})", kVersion, sourceCommit())),
                            fact("Current model", currentModel(session).label)});
  if (const Cell& cell = currentModel(session).cell; cell.sheet)
    facts.push_back(fact("Existing plans remain valid", wordsOf(standingOf(cell))));
  if (session.measurements)
    facts.push_back(fact("Readings in use", fmt::format("{}", measurementsInUse(*session.measurements).size())));
  return facts;
}

/// Adds the verdict on the current model to the report: from its diagnosis, otherwise from its comparison.
void addVerdict(const Session& session, json& report) {
  for (const char* name : {"diagnose", "compare"}) {
    const auto found = findResult(session, name, currentModel(session).id);
    if (!found) continue;
    report["verdict"] = found->document["verdict"];
    report["verdict_words"] = found->document.value("verdict_words", "");
    report["sentence"] = found->document["sentence"];
    // Project files of earlier versions lack these keys.
    for (const char* key : {"sentences", "splitting", "error_unit", "error_budget"})
      if (found->document.contains(key)) report[key] = found->document[key];
    report["rms"] = found->document["rms"];
    report["chi2_per_dof"] = found->document["chi2_per_dof"];
    report["p_value"] = found->document["p_value"];
    // "Before" refers to the first model, not to the current model before its refit.
    if (const json first = figuresOf(session, session.models.front()->id); first.contains("heldout_rms"))
      report["rms"]["heldout_before"] = first["heldout_rms"];
    return;
  }
}

}  // namespace

std::vector<TextFile> projectFiles(const Session& session, const std::filesystem::path& folder) {
  std::vector<TextFile> files;
  for (std::size_t k = 0; k < session.models.size(); ++k)
    for (auto& file : cellFiles(session.models[k]->cell, folder / modelFile(k))) files.push_back(std::move(file));
  if (session.measurements) files.push_back({folder / "measurements.csv", usedMeasurementsText(session)});
  return files;
}

json projectReportJson(const Session& session, const ProjectReportRequest& request) {
  const Cell& cell = session.models.front()->cell;
  json report = {{"title", "Project " + std::filesystem::path(request.project).stem().string()},
                 {"cell", cell.name},
                 {"measurements", session.measurements ? session.measurements->name : ""},
                 {"units", measurementUnitsJson(cell.units)},
                 {"facts", factsJson(session, request)},
                 {"models", modelsOfLadder(session)},
                 {"history", historyJson(session)},
                 {"inputs", inputsJson(session)},
                 {"commands", commandsJson(session, request)},
                 {"version", kVersion},
                 {"commit", sourceCommit()}};
  addVerdict(session, report);
  if (session.measurements) report["set_aside"] = session.measurements->set_aside;
  if (const auto fitted = findResult(session, "identify", currentModel(session).id))
    report["parameters"] = fitted->document["parameters"];
  if (const auto ladder = findResult(session, "ladder"); ladder && !ladder->document["models"].empty())
    report["noise_floor"] = ladder->document["models"].back()["rms"]["noise_floor"];
  return report;
}

}  // namespace tubeplan::app
