// The error of one model after another on the same readings: from models to rows of the comparison and figures.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/files/reading_input.hpp"
#include "app/studies/model/ladder_steps.hpp"

namespace tubeplan::app {

/// A model on its way to the ladder, with the readings as it takes them.
struct LadderModel {
  std::string name;
  CellReadings input;
  const calibration::Identification* fit = nullptr;  ///< as fitForLadder gives it, where it is made already
};

struct LadderRequest {
  std::string truth;  ///< a cell's file; empty: the best model of the ladder, with an unmodelled error
  std::string sheet;  ///< a cell's file, for its sheet and tool; empty: the truth's, else the first cell's that has one
  int holes = 1000;   ///< of the step table
  std::vector<std::string> set_aside = {};  ///< ids of readings that are outliers already; where the last model's fit
                                            ///< is made, all that it was made without
  std::uint64_t seed = 1;
};

struct LadderOutcome {
  std::vector<ModelComparisonRow> comparison;
  LadderSteps steps;
  std::vector<std::string>
      set_aside;           ///< ids of the readings that are outliers of the last model: no model is judged on them
  nlohmann::json figures;  ///< as `tubeplan ladder --json` writes them
};

/// The cell's arm taken as rigid: only its base is fitted.
[[nodiscard]] Cell rigidOf(Cell cell);

/// There must be a model. Outliers of the last are set aside, so that all are judged on the same readings. Throws
/// InputError for sheets that differ, JobStopped.
[[nodiscard]] LadderOutcome climbLadder(const std::vector<LadderModel>& models, const LadderRequest& request,
                                        const WorkHooks& hooks = {});

}  // namespace tubeplan::app
