#include "app/workbench/session.hpp"

#include <algorithm>

namespace tubeplan::app {

std::vector<calibration::Measurement> readingsInUse(const ReadingSet& set) {
  auto readings = set.readings;
  std::erase_if(readings, [&](const auto& reading) { return set.set_aside.contains(reading.id); });
  return readings;
}

std::optional<std::size_t> findModel(const Session& session, int id) {
  const auto at = std::find_if(session.models.begin(), session.models.end(),
                               [&](const ModelPointer& model) { return model->id == id; });
  if (at == session.models.end()) return std::nullopt;
  return static_cast<std::size_t>(at - session.models.begin());
}

ResultPointer findResult(const Session& session, const std::string& name) {
  const auto named = session.results.find(name);
  if (named == session.results.end() || named->second.empty()) return nullptr;
  const auto own = named->second.find(currentModel(session).id);
  if (own != named->second.end()) return own->second;
  ResultPointer newest;
  for (const auto& [model, result] : named->second)
    if (!newest || result->revision > newest->revision) newest = result;
  return newest;
}

ResultPointer findResult(const Session& session, const std::string& name, int model) {
  const auto named = session.results.find(name);
  if (named == session.results.end()) return nullptr;
  const auto own = named->second.find(model);
  return own == named->second.end() ? nullptr : own->second;
}

int pushModel(Session& session, std::string label, std::string origin, Cell cell) {
  while (session.models.size() > session.current + 1) {
    for (auto& [name, by_model] : session.results) by_model.erase(session.models.back()->id);
    session.models.pop_back();
  }
  const int id = session.next_model++;
  session.models.push_back(makeModel(id, std::move(label), std::move(origin), std::move(cell)));
  session.current = session.models.size() - 1;
  return id;
}

void putResult(Session& session, const std::string& name, int model, nlohmann::json document) {
  auto result = std::make_shared<ResultDocument>();
  result->model = model;
  result->revision = session.revision + 1;
  result->document = std::move(document);
  session.results[name][model] = std::move(result);
}

void forgetResultsOfReadings(Session& session) {
  for (const char* name : {"compare", "diagnose", "identify", "ladder", "improve", "touches", "simulate"})
    session.results.erase(name);
}

}  // namespace tubeplan::app
