// Session shared by all browsers: the models of the opened cell, the readings, and the results. It is a value, so that
// each request works on its own copy.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/documents/plan_outcome.hpp"
#include "app/formats/cell/cell_reader.hpp"
#include "calibration/estimation/base_calibration.hpp"
#include "calibration/measurement.hpp"
#include "calibration/measurement_checks/measurement_checks.hpp"
#include "planner/collision/nearest_pairs.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// Cell in memory, with the text of its files and its origin.
struct Model {
  int id = 0;
  std::string label;
  std::string origin;  ///< given, effect, formula, fit, calibration
  Cell cell;
  planner::Workcell posed;                             ///< only arm, base and scene, for questions about postures
  std::shared_ptr<const planner::NearestPairs> pairs;  ///< null if the cell has no bodies
};
using ModelPointer = std::shared_ptr<const Model>;

[[nodiscard]] ModelPointer makeModel(int id, std::string label, std::string origin, Cell cell);

/// Source of readings, kept to read them again with other assumptions.
struct ReadingSource {
  std::vector<std::string> files;    ///< files taken together; empty if the readings came as text
  std::string text;                  ///< text of a measurement file
  double sigma = 0;                  ///< see MeasurementOptions
  std::vector<std::string> assumed;  ///< assumptions made already, in the notation of takeAssumptions()
};

/// Readings of one or more files.
struct ReadingSet {
  std::string name;
  std::vector<calibration::Measurement> readings;  ///< readings, each with its sigma
  calibration::MeasurementChecks checks = {};      ///< suspected mistakes at opening
  std::set<std::string> set_aside = {};            ///< ids excluded from all fits
  int change = 0;                                  ///< number of changes of readings or marks
  /// Files and assumptions that the readings came from; null if they are simulated or of a kept session.
  std::shared_ptr<const ReadingSource> source = {};
  std::set<std::string> joined = {};  ///< ids that joined the others last; empty in a kept session
};

/// Returns the readings that are not set aside.
[[nodiscard]] std::vector<calibration::Measurement> readingsInUse(const ReadingSet& set);

/// Touch of a hole, by the arm itself or by a simulated one.
struct TouchMade {
  calibration::Measurement touch;
  int tube = -1;  ///< index in the sheet
  bool is_simulated = false;
};

/// Document that a command has computed for one model.
struct ResultDocument {
  int model = 0;
  std::uint64_t revision = 0;  ///< revision of the state when the document was added
  nlohmann::json document;
};
using ResultPointer = std::shared_ptr<const ResultDocument>;

struct Session {
  std::uint64_t revision = 1;
  std::vector<ModelPointer> models;  ///< stack, the opened cell first; never empty
  std::size_t current = 0;           ///< index of the current model; those above it are kept for redo
  int next_model = 1;
  std::shared_ptr<const ReadingSet> readings;                   ///< null without readings
  std::map<std::string, std::map<int, ResultPointer>> results;  ///< by name and model
  std::string truth;                                            ///< file of a cell; empty: none
  std::string project;                                          ///< file of the last save; empty: none
  std::uint64_t saved_revision = 0;                             ///< revision in that file
  std::vector<TouchMade> touches;                               ///< touches made one by one
  int next_touch = 1;
  std::shared_ptr<const PlanOutcome> plan;
  PlanRequest plan_request;
};

[[nodiscard]] inline const Model& currentModel(const Session& session) { return *session.models[session.current]; }

/// Returns the index on the stack of the model with that id; nullopt if there is none.
[[nodiscard]] std::optional<std::size_t> findModel(const Session& session, int id);

/// Returns the result of the current model, else the newest of another; null if there is none.
[[nodiscard]] ResultPointer findResult(const Session& session, const std::string& name);

/// Returns the result of that model alone; null if there is none.
[[nodiscard]] ResultPointer findResult(const Session& session, const std::string& name, int model);

/// Puts a model on top of the current one and deletes the models kept for redo, with their results. Returns its id.
int pushModel(Session& session, std::string label, std::string origin, Cell cell);

/// Stores a result. If all documents that list readings are too large together, the oldest ones of other models are
/// dropped.
void putResult(Session& session, const std::string& name, int model, nlohmann::json document);

/// Replaces the readings, with the next change number, and deletes the results of the former ones.
void putReadings(Session& session, std::shared_ptr<ReadingSet> set);

}  // namespace tubeplan::app
