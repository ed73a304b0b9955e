// Identification of a model's parameters and base from measurements: a cell and its measurements give the fit and the
// results as JSON.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/formats/measurements/measurement_input.hpp"
#include "app/studies/job_steps.hpp"
#include "app/studies/positioning/predicted_centring.hpp"
#include "calibration/diagnosis/causes/formula_overlap.hpp"
#include "calibration/diagnosis/effect_warnings.hpp"
#include "calibration/estimation/identification.hpp"
#include "calibration/patterns/comparison.hpp"

namespace tubeplan::app {

inline constexpr int kMostFolds = 100;

struct IdentificationRequest {
  std::string method = "in-turn", robust = "none";
  /// Names of the parameters to free; if empty, the parameters under the cell's `identify`.
  std::vector<std::string> free;
  std::vector<std::string> stages;  ///< stages of the fit, each "NAMES[:SETUP]"; if empty, there is a single fit
  double drop = 0;
  int starts = 1, folds = 5;
  std::uint64_t seed = 1;
  /// Called with the fit of each completed stage except the last; may be empty.
  std::function<void(int stage, const calibration::Identification&)> stage_done = {};
  calibration::IterationObserver observe = {};  ///< called at each iteration of the fit; may be empty
};

struct IdentificationOutcome {
  /// The fit. If the measurements contain a mistake, the fit is not run, and its `reason` names the mistake.
  calibration::Identification fit;
  std::vector<calibration::Measurement> measurements;  ///< measurements fitted: all except the outliers in `set_aside`
  std::vector<std::string> set_aside;                  ///< ids of the measurements excluded as outliers
  std::vector<std::string> warnings;                   ///< warnings about the fit and the measurements
  /// Verdict on the residuals relative to the noise, by the criterion of `compare`; inconclusive if the measurements
  /// contain a mistake.
  calibration::Adequacy adequacy = calibration::Adequacy::kNotRun;
  bool is_base_refused = false;  ///< true if only the base was fitted, and the measurements reject the fit
  std::vector<calibration::FormulaOverlap> overlaps;
  PredictedCentring centring;
  std::vector<calibration::EffectWarning> of_effects;
  nlohmann::json figures;  ///< output of `tubeplan identify --json`
};

/// Identifies the model's parameters. Throws InputError if a name is not a parameter, no parameter is free or the
/// measurements determine none. Throws JobStopped if a stop is requested.
[[nodiscard]] IdentificationOutcome identifyModel(const CellMeasurements& input, const IdentificationRequest& request,
                                                  const WorkHooks& hooks = {});

}  // namespace tubeplan::app
