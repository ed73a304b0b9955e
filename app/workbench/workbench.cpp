#include "app/workbench/workbench.hpp"

#include <filesystem>

#include "app/input_error.hpp"
#include "app/readers/measurements_reader.hpp"
#include "app/reading_input.hpp"

namespace tubeplan::app {

namespace {

namespace fs = std::filesystem;

fs::path folderOf(const WorkbenchOptions& options) {
  if (!options.folder.empty()) return options.folder;
  const fs::path parent = fs::path(options.cell).parent_path();
  return parent.empty() ? fs::path(".") : parent;
}

Situation openAsAsked(const WorkbenchOptions& options) {
  Situation situation = openCell(options.cell, options.truth);
  if (!options.measurements.empty())
    situation.readings = openReadings(options.measurements, currentModel(situation).cell);
  return situation;
}

}  // namespace

Workbench::Workbench(const WorkbenchOptions& options)
    : situation_(openAsAsked(options)), folder_(folderOf(options)), events_(options.most_listeners), jobs_(events_) {}

Situation Workbench::situation() const {
  const std::lock_guard lock(mutex_);
  return situation_;
}

bool Workbench::change(const std::function<bool(Situation&)>& step) {
  {
    const std::lock_guard lock(mutex_);
    Situation changed = situation_;
    if (!step(changed)) return false;
    ++changed.revision;
    situation_ = std::move(changed);
  }
  events_.stateChanged();
  return true;
}

Situation openCell(const std::string& file, const std::string& truth) {
  Situation situation;
  if (!truth.empty()) (void)readCell(truth);
  situation.truth = truth;
  situation.models.push_back(makeModel(0, "as given", "given", readCell(file)));
  return situation;
}

std::shared_ptr<const ReadingSet> openReadings(const std::vector<std::string>& files, const Cell& cell) {
  auto set = std::make_shared<ReadingSet>();
  Cell own = cell;
  auto [readings, checks] = readAndCheck(files, own, {});
  set->readings = std::move(readings);
  set->checks = std::move(checks);
  for (const auto& file : files) set->name += (set->name.empty() ? "" : " + ") + fs::path(file).filename().string();
  return set;
}

}  // namespace tubeplan::app
