// Comparison of several models on the same measurements (a "ladder"): one row with the error of each model.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/formats/measurements/measurement_input.hpp"
#include "app/studies/model/ladder_steps.hpp"

namespace tubeplan::app {

/// One of the compared models: its cell, and the measurements as interpreted with this cell.
struct LadderModel {
  std::string name;
  CellMeasurements input;
  /// Result of fitForLadder(); null if not computed yet.
  const calibration::Identification* fit = nullptr;
};

struct LadderRequest {
  std::string truth;  ///< cell file of the true arm; if empty, the best model with an unmodelled error
  std::string sheet;  ///< cell file with the sheet and the tool; if empty, `truth` or the first cell with both
  int holes = 1000;   ///< number of holes in a step table
  /// Ids of measurements already identified as outliers. If the last model is already fitted, these are all
  /// measurements that its fit excluded.
  std::vector<std::string> set_aside = {};
  std::uint64_t seed = 1;
};

struct LadderOutcome {
  std::vector<ModelComparisonRow> comparison;
  LadderSteps steps;
  std::vector<std::string> set_aside;  ///< ids of outliers of the last model; excluded for all models
  nlohmann::json figures;              ///< output of `tubeplan ladder --json`
};

/// Returns the cell with a rigid arm and with no free parameter but the base pose.
[[nodiscard]] Cell rigidOf(Cell cell);

/// Compares one or more models. Outliers of the last model are excluded for all models, so that all are compared on the
/// same measurements. Throws InputError if the models' tube sheets differ, and JobStopped if a stop is requested.
[[nodiscard]] LadderOutcome runLadder(const std::vector<LadderModel>& models, const LadderRequest& request,
                                      const WorkHooks& hooks = {});

}  // namespace tubeplan::app
