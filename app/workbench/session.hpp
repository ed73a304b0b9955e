// Session shared by all browsers: the models of the opened cell, the measurements, and the results. A session is a
// value type, so that each request works on its own copy.
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

/// A model on the session's stack of models: a cell with the contents of its files, a label and its origin.
struct Model {
  int id = 0;
  std::string label;
  std::string origin;  ///< given, effect, formula, fit, calibration, without or assumption
  Cell cell;
  planner::Workcell posed;                             ///< workcell with only arm, base and scene, to evaluate postures
  std::shared_ptr<const planner::NearestPairs> pairs;  ///< search for the nearest objects; null without bodies
};
using ModelPointer = std::shared_ptr<const Model>;

[[nodiscard]] ModelPointer makeModel(int id, std::string label, std::string origin, Cell cell);

/// Source of measurements, kept so that the measurements can be read again under other assumptions.
struct MeasurementSource {
  std::vector<std::string> files;    ///< files that form one set; empty if the measurements were given as text
  std::string text;                  ///< text of a measurement file; empty if `files` are given
  double sigma = 0;                  ///< sigma of measurements that state none, as in MeasurementOptions
  std::vector<std::string> assumed;  ///< assumptions made so far, in the notation of takeAssumptions()
};

/// Measurements from one or more files.
struct MeasurementSet {
  std::string name;
  std::vector<calibration::Measurement> measurements;  ///< measurements, each with its noise sigma
  calibration::MeasurementChecks checks = {};          ///< mistakes suspected when the measurements were opened
  std::set<std::string> set_aside = {};                ///< ids of measurements excluded from all fits
  int change = 0;                                      ///< number of changes of measurements or marks
  /// Files and assumptions from which the measurements were obtained; null if they are simulated or from a kept
  /// session.
  std::shared_ptr<const MeasurementSource> source = {};
  std::set<std::string> joined = {};  ///< ids of the measurements added last; empty in a kept session
};

/// Returns the measurements that are not set aside.
[[nodiscard]] std::vector<calibration::Measurement> measurementsInUse(const MeasurementSet& set);

/// Touch of a hole, made by the real arm or simulated.
struct TouchMade {
  calibration::Measurement touch;
  int tube = -1;  ///< index of the tube in the sheet; -1 if unknown
  bool is_simulated = false;
};

/// Result document computed for one model.
struct ResultDocument {
  int model = 0;
  std::uint64_t revision = 0;  ///< revision of the state when the document was added
  nlohmann::json document;
};
using ResultPointer = std::shared_ptr<const ResultDocument>;

struct HistoryStep;

/// Results that depend on the measurements.
inline constexpr const char* kResultsOfMeasurements[] = {"compare", "diagnose", "identify", "ladder",
                                                         "improve", "touches",  "simulate"};

struct Session {
  std::uint64_t revision = 1;
  std::vector<ModelPointer> models;  ///< stack of models, the opened cell first; never empty
  std::size_t current = 0;           ///< index of the current model; models above it are kept for redo
  int next_model = 1;
  std::shared_ptr<const MeasurementSet> measurements;           ///< loaded measurements; null if there are none
  std::map<std::string, std::map<int, ResultPointer>> results;  ///< results, keyed by result name and model id
  std::string truth;                                            ///< cell file of the true arm; empty if none
  std::string project;                                          ///< project file last saved; empty if none
  std::uint64_t saved_revision = 0;                             ///< revision of the session in that project file
  std::vector<TouchMade> touches;                               ///< touches in the order in which they were made
  int next_touch = 1;
  std::shared_ptr<const PlanOutcome> plan;  ///< null in a session just opened, until restorePlan() has made it again
  PlanRequest plan_request;
  int plan_model = -1;  ///< id of the model for which the plan was requested; -1: no plan
  /// Steps that can be undone and redone, the newest last (see history.hpp); empty in a kept session.
  std::vector<std::shared_ptr<const HistoryStep>> past = {}, undone = {};
};

[[nodiscard]] inline const Model& currentModel(const Session& session) { return *session.models[session.current]; }

/// Returns the stack index of the model with this id; nullopt if there is none.
[[nodiscard]] std::optional<std::size_t> findModel(const Session& session, int id);

/// Returns the result `name` of the current model; if it has none, the newest of another model; null if no model has
/// one.
[[nodiscard]] ResultPointer findResult(const Session& session, const std::string& name);

/// Returns the result `name` of the given model; null if it has none.
[[nodiscard]] ResultPointer findResult(const Session& session, const std::string& name, int model);

/// Puts a model on the stack above the current model, and makes it current. Deletes the models kept for redo, with
/// their results. Returns the id of the new model.
int pushModel(Session& session, std::string label, std::string origin, Cell cell);

/// Returns a label such as "+ hysteresis at theta4", or "+ joint-compliance at 7 places" for an effect at many places.
[[nodiscard]] std::string causesLabel(const std::string& sign, const std::vector<std::string>& causes);

/// Stores a result. If the documents that list measurements become too large in total, the oldest ones of models other
/// than the current one are deleted.
void putResult(Session& session, const std::string& name, int model, nlohmann::json document);

/// Replaces the measurements, with the next change number, and deletes the results for the previous measurements.
void putMeasurements(Session& session, std::shared_ptr<MeasurementSet> set);

}  // namespace tubeplan::app
