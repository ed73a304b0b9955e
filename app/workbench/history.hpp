// Undo and redo of everything a user changes in a session: the model, the measurements with their marks, the touches.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/workbench/session.hpp"

namespace tubeplan::app {

/// State before a step, as far as undo restores it.
struct SessionPart {
  std::vector<ModelPointer> models;
  std::size_t current = 0;
  std::shared_ptr<const MeasurementSet> measurements;
  std::vector<TouchMade> touches;
  std::map<std::string, std::map<int, ResultPointer>> results;
};

/// Step that can be undone or redone.
struct HistoryStep {
  std::string words;  ///< description of the change, such as "marks of readings"
  SessionPart part;
};

/// Adds the difference between the two states of the session to the steps that can be undone, and deletes the steps
/// that can be redone. A step that undid or redid something is not added.
void noteStep(const Session& before, Session& after);

/// Undoes (`back`) or redoes one step. Without steps, as after a restart, the model below or above the current one on
/// the stack becomes current. Returns false if there is nothing to undo or redo.
bool stepBack(Session& session);
bool stepForward(Session& session);

/// Returns a description of the next undo or redo; empty if there is none.
[[nodiscard]] std::string undoWords(const Session& session);
[[nodiscard]] std::string redoWords(const Session& session);

}  // namespace tubeplan::app
