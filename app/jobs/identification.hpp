// Identification of the numbers of a model and the base: from a cell and its readings to the fit and its figures.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/formats/measurements/reading_input.hpp"
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
  std::vector<std::string> free;    ///< replaces the cell's `identify`
  std::vector<std::string> stages;  ///< "NAMES[:SETUP]" each; empty: all at once
  double drop = 0;
  int starts = 1, folds = 5;
  std::uint64_t seed = 1;
  /// Called with the fit of every stage but the last, as it is done; may be empty.
  std::function<void(int stage, const calibration::Identification&)> stage_done = {};
  calibration::IterationObserver observe = {};  ///< called at the fit's iterations
};

struct IdentificationOutcome {
  calibration::Identification fit;  ///< the fit; not run if the readings hold a mistake, which is its reason
  std::vector<calibration::Measurement> readings;  ///< readings given to the fit: all but those set aside
  std::vector<std::string> set_aside;              ///< ids of outliers
  std::vector<std::string> warnings;               ///< about the readings
  /// Verdict on the remaining error of the fit beside the noise, by the rule of `compare`; inconclusive if there is a
  /// mistake.
  calibration::Adequacy adequacy = calibration::Adequacy::kNotRun;
  bool is_base_refused = false;  ///< true: only the base was found, and the readings do not fit it
  std::vector<calibration::FormulaOverlap> overlaps;
  PredictedCentring centring;
  std::vector<calibration::EffectWarning> of_effects;
  nlohmann::json figures;  ///< JSON of `tubeplan identify --json`
};

/// Identifies the model. Throws InputError for names that are no parameters, nothing to free and readings that
/// determine nothing, JobStopped.
[[nodiscard]] IdentificationOutcome identifyModel(const CellReadings& input, const IdentificationRequest& request,
                                                  const WorkHooks& hooks = {});

}  // namespace tubeplan::app
