// The error of one model after another on the same readings: from models to rows of the comparison and figures.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/files/reading_input.hpp"
#include "app/jobs/ladder_steps.hpp"
#include "app/studies/job_steps.hpp"

namespace tubeplan::app {

/// A model on its way to the ladder, with the readings as it takes them.
struct LadderModel {
  std::string name;
  CellReadings input;
  const calibration::Identification* fit = nullptr;  ///< as fitForLadder gives it, where it is made already
};

struct LadderOutcome {
  std::vector<ModelComparisonRow> comparison;
  LadderSteps steps;
  nlohmann::json figures;  ///< as `tubeplan ladder --json` writes them
};

/// The cell's arm taken as rigid: only its base is fitted.
[[nodiscard]] Cell rigidOf(Cell cell);

/// There must be a model. Throws InputError for sheets that differ, JobStopped.
[[nodiscard]] LadderOutcome climbLadder(const std::vector<LadderModel>& models, const LadderStepOptions& options,
                                        const WorkHooks& hooks = {});

/// The page of --report.
[[nodiscard]] std::string ladderPage(const nlohmann::json& figures, const std::string& measurements,
                                     std::uint64_t seed);

}  // namespace tubeplan::app
