// Improvement of a cell's model by its measurements: diagnoses the error, adds a cause and refits, until no further
// cause is certain.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "app/studies/job_steps.hpp"
#include "app/studies/model/model_comparison.hpp"
#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::app {

/// A fitted model of the loop: the given model, or the model after a step that added a cause.
struct ImprovedModel {
  std::string name;  ///< "as given", or the added causes: "+ backlash@tool.z"
  CellModel cell;    ///< the cell with the added causes, before the fit; `fit` has the fitted values
  calibration::Identification fit;
  int step = 0;                ///< number of steps so far that added a cause
  std::vector<int> set_aside;  ///< indices of the outliers of the last diagnosis, excluded from the fit
};

struct ImprovementRequest {
  int steps = 6;  ///< largest number of steps that add a cause
  std::uint64_t seed = 1;
  /// Called with each fitted model, and again with the last model when it is refitted to other measurements.
  std::function<void(const ImprovedModel&)> on_model;
};

enum class ImprovementEnd {
  kNotRun,
  kAdequate,          ///< the diagnosis finds that the model lacks no effect
  kNothingCertain,    ///< the remaining error is only scatter, or no cause lowers the error of held-out measurements
  kAmbiguous,         ///< the predictions of the alternatives differ by more than the improvement by the best one
  kDoesNotCarryOver,  ///< the cause does not lower the error of held-out measurements, or of the farthest poses
  kMistake,           ///< a mistake in the measurements explains the error
  kInconclusive,      ///< the measurements allow no verdict
  kMostSteps,
  kNotFitted,  ///< the given model could not be fitted
};

/// Reason for adding a cause, or for the end of the loop.
enum class ImprovementReason {
  kNothingMissing,
  /// The residual (magnitude `first`) looks like scatter: it is not a smooth function of the stated variables.
  kScatter,
  kCertain,       ///< the cause is certain and predicts the farthest poses
  kCertainInAll,  ///< the cause is certain in every alternative
  /// Predictions of the alternatives differ by `first`, less than the decrease `second` of the error.
  kAlternativesClose,
  /// Predictions of the alternatives differ by `first`, more than the decrease `second` of the error.
  kAlternativesDiffer,
  kUnsureButLower,  ///< the cause is uncertain, but lowers the error of held-out measurements and of the farthest poses
  kNoneLower,  ///< no cause is certain, and none lowers the error of held-out measurements and of the farthest poses
  kFarthestWorse,  ///< adding the cause raises the error of the farthest poses from `second` to `first`
  /// Refitted together with all other parameters, the cause does not lower the error of held-out measurements.
  kNotLowerTogether,
  kMistakeExplains,
  kNoVerdict,
};

/// One completed round of the improvement loop.
struct ImprovementStep {
  calibration::Diagnosis diagnosis;
  ImprovementReason reason = ImprovementReason::kNoVerdict;
  /// Values that belong to `reason`, as explained at ImprovementReason [m]; NaN if the reason has none.
  double first = std::numeric_limits<double>::quiet_NaN(), second = first;
  std::vector<std::string> added;              ///< names of the added causes; empty if none was added
  std::vector<std::string> indistinguishable;  ///< causes that no measurement distinguishes from the added causes
  std::vector<std::string> not_needed;         ///< added effects that were removed again as hardly significant
  /// Errors of poses held out in folds, before and after the addition.
  calibration::ErrorSize heldout_before, heldout_after;
  /// Errors of the farthest-reaching quarter of the poses, held out of the fit, before and after the addition.
  calibration::ErrorSize farthest_before, farthest_after;
};

struct Improvement {
  ImprovementEnd end = ImprovementEnd::kNotRun;
  std::vector<ImprovementStep> steps;
  /// The given model as first fitted, then one model for each step that added a cause. All are fitted to the same
  /// measurements.
  std::vector<ImprovedModel> models;

  /// Returns true if the result has a model that may be used.
  [[nodiscard]] bool isUsable() const {
    return !models.empty() && end != ImprovementEnd::kNotFitted &&
           !(end == ImprovementEnd::kInconclusive && models.size() == 1);
  }
};

/// Runs the improvement loop. If the measurements determine no free parameter, the loop ends with kNotFitted and a
/// refused fit. Throws JobStopped if a stop is requested.
[[nodiscard]] Improvement improveModel(const CellModel& cell, const std::vector<calibration::Measurement>& measurements,
                                       const ImprovementRequest& request, const WorkHooks& hooks = {});

/// Returns one comparison row for each model of the result, in the order in which the loop fitted them.
[[nodiscard]] std::vector<ModelComparisonRow> comparisonRowsOf(const Improvement& result);

}  // namespace tubeplan::app
