#include "app/workbench/project.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/documents/comparison_json.hpp"
#include "app/formats/cell/cell_writer.hpp"
#include "app/formats/checkpoint/checkpoint_file.hpp"
#include "app/formats/checkpoint/whole_number.hpp"
#include "app/formats/measurements/measurement_input.hpp"
#include "app/formats/measurements/measurements_writer.hpp"
#include "app/formats/sheet/touch_input.hpp"
#include "app/storage/input_error.hpp"
#include "app/version.hpp"
#include "app/workbench/kept_plan.hpp"
#include "app/workbench/measurement_sets.hpp"

namespace tubeplan::app {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr CheckpointFormat kProjectFormat = {"tubeplan project 1", "a project saved by tubeplan serve",
                                             "open the cell and its readings anew"};

std::string allMeasurementsText(const Session& session) {
  const Cell& cell = session.models.front()->cell;
  return session.measurements ? measurementsCsv(session.measurements->measurements, cell.arm, cell.units) : "";
}

// ---- writing

json modelJson(const Model& model) {
  const Cell& cell = model.cell;
  json entry = {{"id", model.id},
                {"label", model.label},
                {"origin", model.origin},
                {"path", fs::absolute(cell.path).string()},
                {"text", cellTextAt(cell, cell.path)}};
  if (!cell.arm_source.text.empty()) entry["arm"] = cell.arm_source.text;
  return entry;
}

json touchesJson(const Session& session) {
  if (session.touches.empty()) return nullptr;
  std::vector<decltype(TouchMade::touch)> touches;
  json tubes = json::array(), simulated = json::array();
  for (const auto& made : session.touches) {
    touches.push_back(made.touch);
    tubes.push_back(made.tube);
    simulated.push_back(made.is_simulated);
  }
  return {{"csv", touchesCsv(touches, session.models.front()->cell)}, {"tubes", tubes}, {"simulated", simulated}};
}

json keptMeasurementsJson(const Session& session) {
  if (!session.measurements) return nullptr;
  return {{"name", session.measurements->name},
          {"csv", allMeasurementsText(session)},
          {"set_aside", session.measurements->set_aside},
          {"change", session.measurements->change}};
}

json keptResultsJson(const Session& session) {
  json results = json::object();
  for (const auto& [name, by_model] : session.results)
    for (const auto& [model, result] : by_model)
      results[name].push_back({{"model", model}, {"revision", result->revision}, {"document", result->document}});
  return results;
}

json keptPlanJson(const Session& session) {
  if (session.plan_model < 0) return nullptr;
  return {{"model", session.plan_model}, {"request", planRequestJson(session.plan_request)}};
}

json payloadOf(const Session& session) {
  json models = json::array();
  for (const auto& model : session.models) models.push_back(modelJson(*model));
  return {{"models", models},
          {"current", session.current},
          {"next_model", session.next_model},
          {"revision", session.revision},
          {"readings", keptMeasurementsJson(session)},
          {"results", keptResultsJson(session)},
          {"truth", session.truth.empty() ? "" : fs::absolute(session.truth).string()},
          {"touches", touchesJson(session)},
          {"next_touch", session.next_touch},
          {"plan", keptPlanJson(session)},
          {"project", session.project},
          {"saved_revision", session.saved_revision}};
}

// ---- reading

ModelPointer modelOf(const json& entry) {
  const std::string path = entry.at("path");
  const auto arm = entry.contains("arm") ? std::optional<std::string>(entry.at("arm")) : std::nullopt;
  return makeModel(wholeNumber<int>(entry.at("id")), entry.at("label"), entry.at("origin"),
                   parseCell(entry.at("text"), path, arm));
}

std::shared_ptr<const MeasurementSet> measurementsOf(const json& entry, const Cell& cell) {
  if (entry.is_null()) return nullptr;
  auto set = std::make_shared<MeasurementSet>();
  set->name = entry.at("name");
  Cell own = cell;
  auto [measurements, checks] = parseAndCheck(entry.at("csv"), set->name, own, {});
  set->measurements = std::move(measurements);
  set->checks = std::move(checks);
  set->set_aside = entry.at("set_aside").get<std::set<std::string>>();
  set->change = wholeNumber<int>(entry.at("change"));
  return set;
}

std::vector<TouchMade> touchesMade(const json& entry, const Cell& cell, const std::string& file) {
  std::vector<TouchMade> made;
  if (entry.is_null()) return made;
  const auto touches = touchesOf(parseMeasurementText(entry.at("csv"), file, cell), cell, file);
  for (std::size_t k = 0; k < touches.size(); ++k)
    made.push_back({touches[k], wholeNumber<int>(entry.at("tubes").at(k)), entry.at("simulated").at(k)});
  return made;
}

/// Pairs of keys of result documents: the name in files of earlier versions, and the current name.
constexpr std::pair<const char*, const char*> kRenamedKeys[] = {
    {"rungs", "models"}, {"told", "identifiable"}, {"probability_told", "probability_distinguished"}};

void renameKeys(json& document) {
  if (document.is_object())
    for (const auto& [before, now] : kRenamedKeys)
      if (const auto found = document.find(before); found != document.end() && !document.contains(now)) {
        json value = std::move(*found);
        document.erase(found);
        document[now] = std::move(value);
      }
  if (document.is_structured())
    for (auto& part : document) renameKeys(part);
}

/// Reverses the sign of a comparison's errors, which earlier versions wrote as predicted minus measured.
void turnErrors(json& comparison) {
  if (comparison.contains("errors") || !comparison.contains("readings")) return;
  for (auto& measurement : comparison.at("readings"))
    for (const char* error : {"error_before", "error_after"})
      for (auto& part : measurement.at(error))
        if (part.is_number()) part = -part.get<double>();
  comparison["errors"] = kErrorsAre;
}

std::map<std::string, std::map<int, ResultPointer>> resultsOf(const json& entry) {
  std::map<std::string, std::map<int, ResultPointer>> results;
  for (const auto& [name, list] : entry.items())
    for (const auto& item : list) {
      auto result = std::make_shared<ResultDocument>();
      result->model = wholeNumber<int>(item.at("model"));
      result->revision = wholeNumber<std::uint64_t>(item.at("revision"));
      result->document = item.at("document");
      renameKeys(result->document);
      if (name == "compare") turnErrors(result->document);
      results[name][result->model] = std::move(result);
    }
  return results;
}

Session sessionOf(const json& payload, const std::string& file) {
  Session session;
  for (const auto& entry : payload.at("models")) session.models.push_back(modelOf(entry));
  session.current = wholeNumber<std::size_t>(payload.at("current"));
  if (session.current >= session.models.size())
    refuseDamaged(kProjectFormat, file, "the file's current model is not in it");
  const Cell& cell = session.models.front()->cell;
  session.next_model = wholeNumber<int>(payload.at("next_model"));
  session.revision = wholeNumber<std::uint64_t>(payload.at("revision"));
  session.measurements = measurementsOf(payload.at("readings"), cell);
  session.results = resultsOf(payload.at("results"));
  session.truth = payload.at("truth");
  session.touches = touchesMade(payload.at("touches"), cell, file);
  session.next_touch = wholeNumber<int>(payload.at("next_touch"));
  if (const json plan = payload.value("plan", json()); !plan.is_null()) {  // missing in files of earlier versions
    session.plan_model = wholeNumber<int>(plan.at("model"));
    session.plan_request = planRequestOf(plan.at("request"));
  }
  session.project = payload.at("project");
  session.saved_revision = wholeNumber<std::uint64_t>(payload.at("saved_revision"));
  return session;
}

}  // namespace

std::string projectText(const Session& session) {
  const PlanKey question = {
      {"program", kVersion},
      {"cell", session.models.front()->cell.name},
      {"cell file", fs::absolute(session.models.front()->cell.path).string()},
      {"readings", session.measurements ? session.measurements->name : ""},
      {"models", std::to_string(session.models.size())},
      {"saved", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))},
  };
  return checkpointText(kProjectFormat, question, payloadOf(session).dump());
}

Session readProject(const fs::path& file) {
  const CheckpointFile kept = readCheckpoint(kProjectFormat, file);
  Session session;
  readPayload(kProjectFormat, file, kept, [&](const json& payload) { session = sessionOf(payload, file.string()); });
  return session;
}

json projectSummary(const fs::path& file) {
  constexpr std::size_t kLongestHead = 1u << 16;
  std::ifstream stream(file, std::ios::binary);
  std::string line(kLongestHead, ' ');
  stream.read(line.data(), static_cast<std::streamsize>(line.size()));
  line.resize(std::min(line.find('\n'), static_cast<std::size_t>(stream.gcount())));
  const json head = json::parse(line, nullptr, false);
  if (!head.is_object() || !head.contains("format") || head["format"] != kProjectFormat.name) return nullptr;
  json summary = {{"file", file.filename().string()}};
  for (const auto& part : head.value("question", json::array()))
    if (part.is_array() && part.size() == 2 && part[0].is_string()) summary[part[0].get<std::string>()] = part[1];
  return summary;
}

bool hasSameInputs(const Session& first, const Session& second) {
  const Cell &a = first.models.front()->cell, &b = second.models.front()->cell;
  return cellTextAt(a, a.path) == cellTextAt(b, b.path) && a.arm_source.text == b.arm_source.text &&
         allMeasurementsText(first) == allMeasurementsText(second);
}

bool hasWork(const Session& session) {
  const auto isMarked = [](const MeasurementSet& set) { return !set.set_aside.empty() || !assumedOf(set).empty(); };
  return session.models.size() > 1 || !session.touches.empty() ||
         (session.measurements && isMarked(*session.measurements));
}

bool isUnsaved(const Session& session) { return hasWork(session) && session.saved_revision != session.revision; }

}  // namespace tubeplan::app
