#include "app/workbench/situation.hpp"

#include <algorithm>

namespace tubeplan::app {

std::vector<calibration::Measurement> readingsInUse(const ReadingSet& set) {
  auto readings = set.readings;
  std::erase_if(readings, [&](const auto& reading) { return set.set_aside.contains(reading.id); });
  return readings;
}

ResultPointer findResult(const Situation& situation, const std::string& name) {
  const auto named = situation.results.find(name);
  if (named == situation.results.end() || named->second.empty()) return nullptr;
  const auto own = named->second.find(currentModel(situation).id);
  if (own != named->second.end()) return own->second;
  ResultPointer newest;
  for (const auto& [model, result] : named->second)
    if (!newest || result->revision > newest->revision) newest = result;
  return newest;
}

ResultPointer findResult(const Situation& situation, const std::string& name, int model) {
  const auto named = situation.results.find(name);
  if (named == situation.results.end()) return nullptr;
  const auto own = named->second.find(model);
  return own == named->second.end() ? nullptr : own->second;
}

int pushModel(Situation& situation, std::string label, std::string origin, Cell cell) {
  while (situation.models.size() > situation.current + 1) {
    for (auto& [name, by_model] : situation.results) by_model.erase(situation.models.back()->id);
    situation.models.pop_back();
  }
  const int id = situation.next_model++;
  situation.models.push_back(makeModel(id, std::move(label), std::move(origin), std::move(cell)));
  situation.current = situation.models.size() - 1;
  return id;
}

void putResult(Situation& situation, const std::string& name, int model, nlohmann::json document) {
  auto result = std::make_shared<ResultDocument>();
  result->model = model;
  result->revision = situation.revision + 1;
  result->document = std::move(document);
  situation.results[name][model] = std::move(result);
}

void forgetResultsOfReadings(Situation& situation) {
  for (const char* name : {"compare", "diagnose", "identify", "ladder", "improve", "touches", "simulate"})
    situation.results.erase(name);
}

}  // namespace tubeplan::app
