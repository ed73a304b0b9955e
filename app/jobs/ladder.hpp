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
  std::uint64_t seed = 1;
};

struct LadderOutcome {
  std::vector<ModelComparisonRow> comparison;
  LadderSteps steps;
  nlohmann::json figures;  ///< as `tubeplan ladder --json` writes them
};

/// The cell's arm taken as rigid: only its base is fitted.
[[nodiscard]] Cell rigidOf(Cell cell);

/// There must be a model. Throws InputError for sheets that differ, JobStopped.
[[nodiscard]] LadderOutcome climbLadder(const std::vector<LadderModel>& models, const LadderRequest& request,
                                        const WorkHooks& hooks = {});

}  // namespace tubeplan::app
