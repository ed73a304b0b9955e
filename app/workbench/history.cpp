#include "app/workbench/history.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tubeplan::app {

namespace {

constexpr std::size_t kMostSteps = 100;

using Steps = std::vector<std::shared_ptr<const HistoryStep>>;

std::vector<std::string> idsOf(const Session& session) {
  std::vector<std::string> ids;
  if (session.measurements)
    for (const auto& reading : session.measurements->measurements) ids.push_back(reading.id);
  return ids;
}

std::vector<std::string> touchIds(const Session& session) {
  std::vector<std::string> ids;
  for (const auto& made : session.touches) ids.push_back(made.touch.id);
  return ids;
}

bool hasOtherModel(const Session& before, const Session& after) {
  return currentModel(before).id != currentModel(after).id || before.models.size() > after.models.size();
}
bool hasOtherMeasurements(const Session& before, const Session& after) {
  return before.measurements != after.measurements && (!before.measurements || idsOf(before) != idsOf(after) ||
                                                       before.measurements->source != after.measurements->source);
}
bool hasOtherMarks(const Session& before, const Session& after) { return before.measurements != after.measurements; }
bool hasOtherTouches(const Session& before, const Session& after) { return touchIds(before) != touchIds(after); }

std::string modelWords(const Session& after) { return "model " + currentModel(after).label; }
std::string measurementWords(const Session& after) { return "readings " + after.measurements->name; }
std::string markWords(const Session&) { return "marks of readings"; }
std::string touchWords(const Session&) { return "touches"; }

/// Changes that are steps, with the words for them. The first row that applies names the step.
struct Change {
  bool (*differs)(const Session& before, const Session& after);
  std::string (*words)(const Session& after);
};
constexpr Change kChanges[] = {{hasOtherModel, modelWords},
                               {hasOtherMeasurements, measurementWords},
                               {hasOtherMarks, markWords},
                               {hasOtherTouches, touchWords}};

SessionPart partOf(const Session& session) {
  return {session.models, session.current, session.measurements, session.touches, session.results};
}

void push(Steps& steps, std::string words, SessionPart part) {
  if (steps.size() >= kMostSteps) steps.erase(steps.begin());
  steps.push_back(std::make_shared<const HistoryStep>(HistoryStep{std::move(words), std::move(part)}));
}

/// Makes the model of the part current. Models above it stay if the stack begins with the part's models.
void restoreModels(const SessionPart& part, Session& session) {
  const auto is_same = [](const ModelPointer& one, const ModelPointer& other) { return one->id == other->id; };
  const bool is_prefix = part.models.size() <= session.models.size() &&
                         std::equal(part.models.begin(), part.models.end(), session.models.begin(), is_same);
  if (!is_prefix) session.models = part.models;
  session.current = part.current;
}

/// Restores measurements and the results obtained with them. The measurements get a new change number, by which jobs
/// and browsers detect that they have changed.
void restoreMeasurements(const SessionPart& part, Session& session) {
  if (part.measurements == session.measurements) return;
  const int change = session.measurements ? session.measurements->change + 1 : part.measurements->change + 1;
  std::shared_ptr<MeasurementSet> measurements;
  if (part.measurements) {
    measurements = std::make_shared<MeasurementSet>(*part.measurements);
    measurements->change = change;
  }
  session.measurements = measurements;
  for (const char* name : kResultsOfMeasurements) {
    session.results.erase(name);
    if (const auto known = part.results.find(name); known != part.results.end()) session.results.insert(*known);
  }
}

/// Deletes the results of models that are no longer on the stack.
void dropResultsOfOthers(Session& session) {
  for (auto& [name, by_model] : session.results)
    std::erase_if(by_model, [&](const auto& entry) { return !findModel(session, entry.first); });
}

bool step(Steps& from, Steps& to, Session& session) {
  if (from.empty()) return false;
  const auto taken = from.back();
  from.pop_back();
  push(to, taken->words, partOf(session));
  restoreModels(taken->part, session);
  restoreMeasurements(taken->part, session);
  session.touches = taken->part.touches;
  dropResultsOfOthers(session);
  return true;
}

}  // namespace

void noteStep(const Session& before, Session& after) {
  if (before.past != after.past || before.undone != after.undone) return;
  const auto change = std::find_if(std::begin(kChanges), std::end(kChanges),
                                   [&](const Change& row) { return row.differs(before, after); });
  if (change == std::end(kChanges)) return;
  push(after.past, change->words(after), partOf(before));
  after.undone.clear();
}

bool stepBack(Session& session) {
  if (step(session.past, session.undone, session)) return true;
  if (session.current == 0) return false;
  --session.current;
  return true;
}

bool stepForward(Session& session) {
  if (step(session.undone, session.past, session)) return true;
  if (session.current + 1 >= session.models.size()) return false;
  ++session.current;
  return true;
}

std::string undoWords(const Session& session) {
  if (!session.past.empty()) return session.past.back()->words;
  return session.current > 0 ? modelWords(session) : "";
}

std::string redoWords(const Session& session) {
  if (!session.undone.empty()) return session.undone.back()->words;
  return session.current + 1 < session.models.size() ? "model " + session.models[session.current + 1]->label : "";
}

}  // namespace tubeplan::app
