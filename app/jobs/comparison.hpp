// Comparison of a model with readings: from a cell and its readings to the figures on where it fails, by how much, and
// what its error follows.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "app/formats/measurements/reading_input.hpp"
#include "app/jobs/outliers.hpp"
#include "app/studies/job_steps.hpp"
#include "calibration/patterns/comparison.hpp"

namespace tubeplan::app {

struct ComparisonRequest {
  int folds = 5;
  std::uint64_t seed = 1;
};

struct ComparisonOutcome {
  calibration::Comparison comparison;
  std::vector<calibration::Measurement> readings;  ///< all but those set aside
  std::vector<std::string> set_aside;              ///< ids of outliers
  std::vector<std::string> warnings;               ///< warnings of the fit
  nlohmann::json figures;                          ///< JSON of `tubeplan compare --json`
};

/// Refits the readings. Throws JobStopped.
[[nodiscard]] RefitOfReadings refitReadings(const CellReadings& input, const ComparisonRequest& request,
                                            const WorkHooks& hooks = {});

/// Compares the model. `made`: the refit, if it exists already. Throws InputError for a list `identify` that names no
/// parameters and for readings that determine nothing, JobStopped.
[[nodiscard]] ComparisonOutcome compareModel(const CellReadings& input, const ComparisonRequest& request,
                                             const WorkHooks& hooks = {}, const RefitOfReadings* made = nullptr);

/// Returns the pattern search of the refit's errors, as `tested` of the figures; empty if it cannot be made.
[[nodiscard]] nlohmann::json testedPatterns(const CellReadings& input, std::uint64_t seed, const WorkHooks& hooks = {});

}  // namespace tubeplan::app
