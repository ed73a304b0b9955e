#include "app/workbench/workbench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/formats/measurements/measurement_input.hpp"
#include "app/formats/measurements/measurements_reader.hpp"
#include "app/storage/input_error.hpp"
#include "app/workbench/history.hpp"
#include "app/workbench/kept_plan.hpp"
#include "app/workbench/measurement_sets.hpp"
#include "app/workbench/project.hpp"

namespace tubeplan::app {

namespace {

namespace fs = std::filesystem;

bool isProject(const std::string& file) { return fs::path(file).extension() == kProjectExtension; }

fs::path stateFolderOf(const WorkbenchOptions& options) {
  if (!options.folder.empty()) return options.folder;
  const fs::path parent = fs::path(options.cell).parent_path();
  return parent.empty() ? fs::path(".") : parent;
}

Session openSession(const WorkbenchOptions& options) {
  Session session = openCell(options.cell, options.truth);
  if (!options.measurement_files.empty()) {
    session.measurements = openMeasurements(options.measurement_files, currentModel(session).cell);
    session.results.clear();
  }
  return session;
}

/// Returns true if the kept session has the current text of the cell file and the requested measurements; if no
/// measurements are requested, any are accepted.
bool canResume(const Session& kept, const Session& requested) {
  Session inputs = requested;
  if (!inputs.measurements) inputs.measurements = kept.measurements;
  return hasSameInputs(kept, inputs) && (requested.truth.empty() || kept.truth == fs::absolute(requested.truth));
}

/// Returns the kept session if it matches the requested one; otherwise returns the requested session and renames the
/// kept one.
Session resumeOrOpen(SessionKeeper& keeper, Session requested, const WorkbenchOptions& options) {
  const bool is_project = isProject(options.cell);
  auto kept = keeper.begin(requested.models.front()->cell.path);
  if (!kept) return requested;
  if (!options.fresh && !is_project && canResume(*kept, requested)) return std::move(*kept);
  if (hasWork(*kept)) {
    keeper.putAside();
    fmt::print(stderr, "tubeplan: {}; the saved session remains under Open, Recent\n",
               options.fresh || is_project ? "begun anew" : "cell or readings differ from the saved ones");
  }
  return requested;
}

}  // namespace

Workbench::Workbench(const WorkbenchOptions& options)
    : folder_(stateFolderOf(options)), keeper_(options.state), events_(options.most_listeners), jobs_(events_) {
  session_ = resumeOrOpen(keeper_, openSession(options), options);
  keeper_.keep(session_);
  restorePlan(*this);
}

Session Workbench::session() const {
  const std::lock_guard lock(mutex_);
  return session_;
}

bool Workbench::change(const std::function<bool(Session&)>& step, bool is_noted) {
  Session changed;
  {
    const std::lock_guard lock(mutex_);
    changed = session_;
    if (!step(changed)) return false;
    if (is_noted) noteStep(session_, changed);
    ++changed.revision;
    session_ = changed;
  }
  keeper_.keep(changed);  // store the change before any browser receives it
  events_.stateChanged();
  return true;
}

bool Workbench::replace(Session session) {
  if (jobs_.isBusy()) return false;
  const auto kept = keeper_.begin(session.models.front()->cell.path);
  if (kept && hasWork(*kept)) keeper_.putAside();
  const auto take = [&](Session& now) {
    const bool is_saved = session.saved_revision == session.revision;
    const std::uint64_t revision = std::max(now.revision, session.revision);
    now = std::move(session);
    now.revision = revision;
    now.saved_revision = is_saved ? revision + 1 : 0;  // change() increments the revision after this step
    return true;
  };
  (void)change(take, false);
  restorePlan(*this);
  return true;
}

Session openCell(const std::string& file, const std::string& truth) {
  if (isProject(file)) return readProject(file);
  Session session;
  if (!truth.empty()) (void)readCell(truth);
  session.truth = truth;
  session.models.push_back(makeModel(0, "as given", "given", readCell(file)));
  return session;
}

}  // namespace tubeplan::app
