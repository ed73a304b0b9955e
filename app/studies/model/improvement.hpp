// Repeated diagnosis, addition and identification, until no further cause is certain: from a cell's model and its
// readings to the improved model.
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

/// A fitted model of the loop: as given, or after a step.
struct ImprovedModel {
  std::string name;  ///< "as given", "+ backlash@tool.z"
  CellModel cell;    ///< the cell with the additions; its numbers are those of `fit`
  calibration::Identification fit;
  int step = 0;                ///< number of steps before that added something
  std::vector<int> set_aside;  ///< readings left out of the fit as outliers of the last diagnosis
};

struct ImprovementRequest {
  int steps = 6;  ///< largest number of steps that add something
  std::uint64_t seed = 1;
  /// Called with every model once it is fitted; again if it is fitted to other readings.
  std::function<void(const ImprovedModel&)> on_model;
};

enum class ImprovementEnd {
  kNotRun,
  kAdequate,     ///< nothing is missing
  kNothingSure,  ///< something is missing, but no cause lowers the error of held-out readings, or the noise is larger
  kAmbiguous,    ///< alternatives differ over the arm's range by more than the first gains
  kDoesNotCarryOver,  ///< the cause does not lower the error of held-out readings, or of the farthest poses
  kMistake,           ///< a mistake in the readings explains the error
  kInconclusive,      ///< the readings allow no verdict
  kMostSteps,
  kNotFitted,  ///< the given model cannot be fitted
};

/// Reason for adding a cause, or for the end of the loop.
enum class ImprovementReason {
  kNothingMissing,
  kScatter,            ///< the remaining error follows no smooth function of the stated variables; `first`: its size
  kSure,               ///< the cause is certain and predicts the farthest poses
  kSureInAll,          ///< the cause is certain in every alternative
  kAlternativesClose,  ///< alternatives differ by `first` over the arm's range, less than the gain `second`
  kAlternativesApart,  ///< alternatives differ by `first`, more than the gain `second`
  kUnsureButLower,     ///< the cause is uncertain, but lowers the error of held-out readings and of the farthest poses
  kNoneLower,          ///< no cause is certain, and none lowers those errors
  kFarthestWorse,      ///< the error of the farthest poses with a fit to the nearer ones is `first`, before `second`
  kNotLowerTogether,   ///< the cause, fitted with everything else, does not lower the error of held-out readings
  kMistakeExplains,
  kNoVerdict,
};

/// One completed round of the loop.
struct ImprovementStep {
  calibration::Diagnosis diagnosis;
  ImprovementReason reason = ImprovementReason::kNoVerdict;
  double first = std::numeric_limits<double>::quiet_NaN(), second = first;  ///< see ImprovementReason [m]
  std::vector<std::string> added;                        ///< names of added causes; empty in the last round
  std::vector<std::string> also;                         ///< causes that no reading distinguishes from the added ones
  std::vector<std::string> not_needed;                   ///< members of a cause that the fit found to be zero
  calibration::ErrorSize heldout_before, heldout_after;  ///< errors with folds of poses held out
  /// Errors with the quarter of the poses that reach farthest held out.
  calibration::ErrorSize farthest_before, farthest_after;
};

struct Improvement {
  ImprovementEnd end = ImprovementEnd::kNotRun;
  std::vector<ImprovementStep> steps;
  /// The given model as first fitted, then one for each step that added something. All are fitted to the same readings.
  std::vector<ImprovedModel> models;

  /// Returns true if there is a usable model.
  [[nodiscard]] bool isUsable() const {
    return !models.empty() && end != ImprovementEnd::kNotFitted &&
           !(end == ImprovementEnd::kInconclusive && models.size() == 1);
  }
};

/// Runs the loop. If readings determine nothing it ends as kNotFitted, with the fit refused. Throws JobStopped.
[[nodiscard]] Improvement improveModel(const CellModel& cell, const std::vector<calibration::Measurement>& readings,
                                       const ImprovementRequest& request, const WorkHooks& hooks = {});

/// Returns the rows of the models for a ladder.
[[nodiscard]] std::vector<ModelComparisonRow> comparisonRowsOf(const Improvement& result);

}  // namespace tubeplan::app
