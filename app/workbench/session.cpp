#include "app/workbench/session.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "calibration/diagnosis/causes/cause.hpp"

namespace tubeplan::app {

ModelPointer makeModel(int id, std::string label, std::string origin, Cell cell) {
  auto model = std::make_shared<Model>();
  model->id = id;
  model->label = std::move(label);
  model->origin = std::move(origin);
  model->cell = std::move(cell);
  model->posed.arm = model->cell.arm;
  model->posed.X_WB = model->cell.X_WB;
  model->posed.scene = model->cell.scene;
  if (!model->cell.scene.bodies.empty())
    model->pairs = std::make_shared<const planner::NearestPairs>(model->cell.scene);
  return model;
}

std::vector<calibration::Measurement> measurementsInUse(const MeasurementSet& set) {
  auto measurements = set.measurements;
  std::erase_if(measurements, [&](const auto& measurement) { return set.set_aside.contains(measurement.id); });
  return measurements;
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

std::string causesLabel(const std::string& sign, const std::vector<std::string>& causes) {
  constexpr int kMany = 3;
  const auto kindOf = [](const std::string& cause) { return cause.substr(0, cause.find('@')); };
  std::vector<std::string> parts;
  for (const auto& cause : causes) {
    const auto places =
        std::ranges::count_if(causes, [&](const std::string& other) { return kindOf(other) == kindOf(cause); });
    const std::string part =
        places < kMany ? calibration::causeTitle(cause) : fmt::format("{} at {} places", kindOf(cause), places);
    if (std::ranges::find(parts, part) == parts.end()) parts.push_back(part);
  }
  return fmt::format("{} {}", sign, fmt::join(parts, " + "));
}

namespace {

/// Largest total number of measurements that all result documents together may list, about 100 MiB: enough for two
/// comparisons of as many measurements as may be loaded.
constexpr std::size_t kMostListed = 40000;

std::size_t measurementsListed(const ResultDocument& result) {
  const auto measurements = result.document.find("readings");
  return measurements == result.document.end() || !measurements->is_array() ? 0 : measurements->size();
}

/// Deletes the oldest documents that list measurements, except those of the current model, until the limit holds.
/// Deleted documents are computed again when their model becomes current.
void boundResults(Session& session) {
  for (;;) {
    std::size_t all = 0;
    std::map<int, ResultPointer>* of_oldest = nullptr;
    ResultPointer oldest;
    for (auto& [name, by_model] : session.results)
      for (const auto& [model, result] : by_model) {
        const std::size_t measurements = measurementsListed(*result);
        all += measurements;
        if (model == currentModel(session).id || measurements == 0) continue;
        if (oldest && oldest->revision <= result->revision) continue;
        oldest = result;
        of_oldest = &by_model;
      }
    if (all <= kMostListed || !oldest) return;
    of_oldest->erase(oldest->model);
  }
}

}  // namespace

void putResult(Session& session, const std::string& name, int model, nlohmann::json document) {
  auto result = std::make_shared<ResultDocument>();
  result->model = model;
  result->revision = session.revision + 1;
  result->document = std::move(document);
  session.results[name][model] = std::move(result);
  boundResults(session);
}

void putMeasurements(Session& session, std::shared_ptr<MeasurementSet> set) {
  set->change = session.measurements ? session.measurements->change + 1 : 0;
  session.measurements = std::move(set);
  for (const char* name : kResultsOfMeasurements) session.results.erase(name);
}

}  // namespace tubeplan::app
