// What all browsers share: the opened cell's models, the readings, and what has been found out about them. A value, so
// that whoever answers a request works on a copy of its own that nobody changes.
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

/// A cell in memory, as it would stand in its files, and where it comes from.
struct Model {
  int id = 0;
  std::string label;
  std::string origin;  ///< given, effect, formula, fit, calibration
  Cell cell;
  planner::Workcell posed;                             ///< arm, base and scene alone: what a posture is asked of
  std::shared_ptr<const planner::NearestPairs> pairs;  ///< none where the cell has no bodies
};
using ModelPointer = std::shared_ptr<const Model>;

[[nodiscard]] ModelPointer makeModel(int id, std::string label, std::string origin, Cell cell);

/// Where readings were read from, to be read again with what is said to be wrong with them.
struct ReadingSource {
  std::vector<std::string> files;    ///< taken together; none where they came as text
  std::string text;                  ///< of a measurement file
  double sigma = 0;                  ///< as MeasurementOptions has it
  std::vector<std::string> assumed;  ///< as takeAssumptions() wants them: taken already
};

/// Readings of one or more files.
struct ReadingSet {
  std::string name;
  std::vector<calibration::Measurement> readings;  ///< each with its sigma
  calibration::MeasurementChecks checks = {};      ///< what looked wrong when they were opened
  std::set<std::string> set_aside = {};            ///< ids of those that no fit sees
  int change = 0;                                  ///< how often readings or marks have changed
  /// None of simulated readings and of a kept session.
  std::shared_ptr<const ReadingSource> source = {};
  std::set<std::string> joined = {};  ///< ids of those that joined the others last; none of a kept session
};

/// Those that are not set aside.
[[nodiscard]] std::vector<calibration::Measurement> readingsInUse(const ReadingSet& set);

/// A hole touched, by the arm itself or by a simulated one.
struct TouchMade {
  calibration::Measurement touch;
  int tube = -1;  ///< index in the sheet
  bool is_simulated = false;
};

/// A document that a command has given for one model.
struct ResultDocument {
  int model = 0;
  std::uint64_t revision = 0;  ///< of the state, when it was put there
  nlohmann::json document;
};
using ResultPointer = std::shared_ptr<const ResultDocument>;

struct Session {
  std::uint64_t revision = 1;
  std::vector<ModelPointer> models;  ///< a stack, the opened cell first; never empty
  std::size_t current = 0;           ///< those above it are there to be done again
  int next_model = 1;
  std::shared_ptr<const ReadingSet> readings;                   ///< none: null
  std::map<std::string, std::map<int, ResultPointer>> results;  ///< by name and model
  std::string truth;                                            ///< a cell's file; empty: none
  std::string project;                                          ///< the file it was last saved as; empty: none
  std::uint64_t saved_revision = 0;                             ///< the revision that stands there
  std::vector<TouchMade> touches;                               ///< made one by one
  int next_touch = 1;
  std::shared_ptr<const PlanOutcome> plan;
  PlanRequest plan_request;
};

[[nodiscard]] inline const Model& currentModel(const Session& session) { return *session.models[session.current]; }

/// Where on the stack the model of that number is; nothing where there is none.
[[nodiscard]] std::optional<std::size_t> findModel(const Session& session, int id);

/// The result of the current model, else the newest of another; null where there is none.
[[nodiscard]] ResultPointer findResult(const Session& session, const std::string& name);

/// Of that model alone; null where there is none.
[[nodiscard]] ResultPointer findResult(const Session& session, const std::string& name, int model);

/// Puts a model on top of the current one; what was there to be done again is gone, with its results. Returns its id.
int pushModel(Session& session, std::string label, std::string origin, Cell cell);

/// Of other models' documents that list readings the oldest give way where all would be too large.
void putResult(Session& session, const std::string& name, int model, nlohmann::json document);

/// Takes these for the readings, one change later than those before; what was found out from those is gone.
void putReadings(Session& session, std::shared_ptr<ReadingSet> set);

}  // namespace tubeplan::app
