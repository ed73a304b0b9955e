// The error of one model after another on the same readings: from models to rows of the comparison and figures.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/formats/measurements/reading_input.hpp"
#include "app/studies/model/ladder_steps.hpp"

namespace tubeplan::app {

/// A model for the ladder, with the readings in its form.
struct LadderModel {
  std::string name;
  CellReadings input;
  const calibration::Identification* fit = nullptr;  ///< result of fitForLadder(), if it exists already
};

struct LadderRequest {
  std::string truth;  ///< a cell's file; empty: the best model of the ladder, with an unmodelled error
  std::string sheet;  ///< a cell's file, for its sheet and tool; empty: the truth's, else the first cell's that has one
  int holes = 1000;   ///< number in the step table
  /// Ids of readings that are outliers already; if the last model's fit exists, all that it was made without.
  std::vector<std::string> set_aside = {};
  std::uint64_t seed = 1;
};

struct LadderOutcome {
  std::vector<ModelComparisonRow> comparison;
  LadderSteps steps;
  std::vector<std::string> set_aside;  ///< ids of outliers of the last model: no model is judged on them
  nlohmann::json figures;              ///< JSON of `tubeplan ladder --json`
};

/// Returns the cell with its arm taken as rigid, so that only its base is fitted.
[[nodiscard]] Cell rigidOf(Cell cell);

/// Compares the models, of which there must be one or more. Outliers of the last are set aside, so that all are judged
/// on the same readings. Throws InputError for sheets that differ, JobStopped.
[[nodiscard]] LadderOutcome climbLadder(const std::vector<LadderModel>& models, const LadderRequest& request,
                                        const WorkHooks& hooks = {});

}  // namespace tubeplan::app
