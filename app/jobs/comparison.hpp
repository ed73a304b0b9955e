// Comparison of a model with measurements: where the model fails, by how much, and which variables its error depends
// on.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "app/formats/measurements/measurement_input.hpp"
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
  std::vector<calibration::Measurement>
      measurements;                    ///< measurements compared: all except the outliers in `set_aside`
  std::vector<std::string> set_aside;  ///< ids of the measurements excluded as outliers
  std::vector<std::string> warnings;   ///< warnings about the fit
  nlohmann::json figures;              ///< output of `tubeplan compare --json`
};

/// Refits the model to the measurements and, if some are outliers, again without them. Throws JobStopped if a stop
/// is requested.
[[nodiscard]] RefitOfMeasurements refitMeasurements(const CellMeasurements& input, const ComparisonRequest& request,
                                                    const WorkHooks& hooks = {});

/// Compares the model with the measurements. `made` is an existing refit, or null to compute one. Throws InputError if
/// `identify` lists a name that is not a parameter, or if the measurements determine no parameter. Throws JobStopped if
/// a stop is requested.
[[nodiscard]] ComparisonOutcome compareModel(const CellMeasurements& input, const ComparisonRequest& request,
                                             const WorkHooks& hooks = {}, const RefitOfMeasurements* made = nullptr);

/// Returns the results of the pattern tests on the errors after the refit, as in `tested` of the comparison's JSON; an
/// empty array if the comparison throws InputError.
[[nodiscard]] nlohmann::json testedPatterns(const CellMeasurements& input, std::uint64_t seed,
                                            const WorkHooks& hooks = {});

}  // namespace tubeplan::app
