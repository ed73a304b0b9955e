#include "app/workbench/project.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/files/cell_writer.hpp"
#include "app/files/checkpoint/kept_file.hpp"
#include "app/files/input_error.hpp"
#include "app/files/measurements_writer.hpp"
#include "app/files/reading_input.hpp"
#include "app/files/touch_input.hpp"
#include "app/version.hpp"

namespace tubeplan::app {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr KeptFormat kFormat = {"tubeplan project 1", "a project as tubeplan serve leaves it",
                                "open the cell and its readings anew"};
/// Made of what cannot be kept: the planner's own memory makes a plan again faster.
constexpr const char* kNotKept = "plan";

std::string readingsText(const Situation& situation) {
  const Cell& cell = situation.models.front()->cell;
  return situation.readings ? measurementsCsv(situation.readings->readings, cell.arm, cell.units) : "";
}

// ---- out

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

json touchesJson(const Situation& situation) {
  if (situation.touches.empty()) return nullptr;
  std::vector<decltype(TouchMade::touch)> touches;
  json tubes = json::array(), simulated = json::array();
  for (const auto& made : situation.touches) {
    touches.push_back(made.touch);
    tubes.push_back(made.tube);
    simulated.push_back(made.is_simulated);
  }
  return {{"csv", touchesCsv(touches, situation.models.front()->cell)}, {"tubes", tubes}, {"simulated", simulated}};
}

json readingsJson(const Situation& situation) {
  if (!situation.readings) return nullptr;
  return {{"name", situation.readings->name},
          {"csv", readingsText(situation)},
          {"set_aside", situation.readings->set_aside},
          {"change", situation.readings->change}};
}

json resultsJson(const Situation& situation) {
  json results = json::object();
  for (const auto& [name, by_model] : situation.results) {
    if (name == kNotKept) continue;
    for (const auto& [model, result] : by_model)
      results[name].push_back({{"model", model}, {"revision", result->revision}, {"document", result->document}});
  }
  return results;
}

json payloadOf(const Situation& situation) {
  json models = json::array();
  for (const auto& model : situation.models) models.push_back(modelJson(*model));
  return {{"models", models},
          {"current", situation.current},
          {"next_model", situation.next_model},
          {"revision", situation.revision},
          {"readings", readingsJson(situation)},
          {"results", resultsJson(situation)},
          {"truth", situation.truth.empty() ? "" : fs::absolute(situation.truth).string()},
          {"touches", touchesJson(situation)},
          {"next_touch", situation.next_touch},
          {"project", situation.project},
          {"saved_revision", situation.saved_revision}};
}

// ---- in

ModelPointer modelOf(const json& entry) {
  const std::string path = entry.at("path");
  const auto arm = entry.contains("arm") ? std::optional<std::string>(entry.at("arm")) : std::nullopt;
  return makeModel(entry.at("id"), entry.at("label"), entry.at("origin"), parseCell(entry.at("text"), path, arm));
}

std::shared_ptr<const ReadingSet> readingsOf(const json& entry, const Cell& cell) {
  if (entry.is_null()) return nullptr;
  auto set = std::make_shared<ReadingSet>();
  set->name = entry.at("name");
  Cell own = cell;
  auto [readings, checks] = parseAndCheck(entry.at("csv"), set->name, own, {});
  set->readings = std::move(readings);
  set->checks = std::move(checks);
  set->set_aside = entry.at("set_aside").get<std::set<std::string>>();
  set->change = entry.at("change");
  return set;
}

std::vector<TouchMade> touchesMade(const json& entry, const Cell& cell, const std::string& file) {
  std::vector<TouchMade> made;
  if (entry.is_null()) return made;
  const auto touches = touchesOf(parseReadings(entry.at("csv"), file, cell), cell, file);
  for (std::size_t k = 0; k < touches.size(); ++k)
    made.push_back({touches[k], entry.at("tubes").at(k), entry.at("simulated").at(k)});
  return made;
}

std::map<std::string, std::map<int, ResultPointer>> resultsOf(const json& entry) {
  std::map<std::string, std::map<int, ResultPointer>> results;
  for (const auto& [name, list] : entry.items())
    for (const auto& item : list) {
      auto result = std::make_shared<ResultDocument>();
      result->model = item.at("model");
      result->revision = item.at("revision");
      result->document = item.at("document");
      results[name][result->model] = std::move(result);
    }
  return results;
}

Situation situationOf(const json& payload, const std::string& file) {
  Situation situation;
  for (const auto& entry : payload.at("models")) situation.models.push_back(modelOf(entry));
  situation.current = payload.at("current");
  if (situation.current >= situation.models.size()) refuseDamaged(kFormat, file, "a current model that is not in it");
  const Cell& cell = situation.models.front()->cell;
  situation.next_model = payload.at("next_model");
  situation.revision = payload.at("revision");
  situation.readings = readingsOf(payload.at("readings"), cell);
  situation.results = resultsOf(payload.at("results"));
  situation.truth = payload.at("truth");
  situation.touches = touchesMade(payload.at("touches"), cell, file);
  situation.next_touch = payload.at("next_touch");
  situation.project = payload.at("project");
  situation.saved_revision = payload.at("saved_revision");
  return situation;
}

}  // namespace

std::string projectText(const Situation& situation) {
  const PlanQuestion question = {
      {"program", kVersion},
      {"cell", situation.models.front()->cell.name},
      {"cell file", fs::absolute(situation.models.front()->cell.path).string()},
      {"readings", situation.readings ? situation.readings->name : ""},
      {"models", std::to_string(situation.models.size())},
      {"saved", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))},
  };
  return keptText(kFormat, question, payloadOf(situation).dump());
}

Situation readProject(const fs::path& file) {
  const KeptFile kept = readKeptFile(kFormat, file);
  Situation situation;
  readPayload(kFormat, file, kept, [&](const json& payload) { situation = situationOf(payload, file.string()); });
  return situation;
}

json projectSummary(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  if (!std::getline(stream, line)) return nullptr;
  const json head = json::parse(line, nullptr, false);
  if (!head.is_object() || head.value("format", "") != kFormat.name) return nullptr;
  json summary = {{"file", file.filename().string()}};
  for (const auto& part : head.value("question", json::array()))
    if (part.is_array() && part.size() == 2 && part[0].is_string()) summary[part[0].get<std::string>()] = part[1];
  return summary;
}

bool hasSameInputs(const Situation& one, const Situation& other) {
  const Cell &a = one.models.front()->cell, &b = other.models.front()->cell;
  return cellTextAt(a, a.path) == cellTextAt(b, b.path) && a.arm_source.text == b.arm_source.text &&
         readingsText(one) == readingsText(other);
}

bool hasWork(const Situation& situation) {
  return situation.models.size() > 1 || !situation.touches.empty() ||
         (situation.readings && !situation.readings->set_aside.empty());
}

bool isUnsaved(const Situation& situation) {
  return hasWork(situation) && situation.saved_revision != situation.revision;
}

}  // namespace tubeplan::app
