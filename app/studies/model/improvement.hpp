// Diagnose, add, identify, until nothing more is sure: from a cell's model and its readings to the improved one.
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

/// A model on the way, fitted: as given, and after each step.
struct ImprovedModel {
  std::string name;  ///< "as given", "+ backlash@tool.z"
  CellModel cell;    ///< with what was added; its numbers are those of `fit`
  calibration::Identification fit;
  int step = 0;                ///< how many added something
  std::vector<int> set_aside;  ///< readings left out of the fit: the last diagnosis took them for outliers
};

struct ImprovementRequest {
  int steps = 6;  ///< the most that add something
  std::uint64_t seed = 1;
  /// Called with every model once it is fitted; with one again that is fitted to other readings.
  std::function<void(const ImprovedModel&)> on_model;
};

enum class ImprovementEnd {
  kNotRun,
  kAdequate,          ///< nothing is missing
  kNothingSure,       ///< something is, and no cause lowers the error where it was not fitted, or the noise is larger
  kAmbiguous,         ///< alternatives differ over the arm's range by more than the first gains
  kDoesNotCarryOver,  ///< the cause does not lower the error of readings kept out, or of the farthest poses
  kMistake,           ///< a mistake with the readings explains the error
  kInconclusive,      ///< the readings allow no verdict
  kMostSteps,
  kNotFitted,  ///< the model as given cannot be fitted
};

/// Why a cause was added, or why the loop ends.
enum class ImprovementReason {
  kNothingMissing,
  kScatter,            ///< what is left follows no smooth function of what the readings state; `first`: its size
  kSure,               ///< and it predicts the farthest poses
  kSureInAll,          ///< in every alternative
  kAlternativesClose,  ///< they differ by `first` over the arm's range, less than the gain `second`
  kAlternativesApart,  ///< they differ by `first`, more than the gain `second`
  kUnsureButLower,     ///< it lowers the error of readings kept out and of the farthest poses
  kNoneLower,          ///< no cause is sure, and none lowers those
  kFarthestWorse,      ///< by a fit to the nearer poses the farthest are `first`, `second` before
  kNotLowerTogether,   ///< fitted with everything else it does not lower the error of readings kept out
  kMistakeExplains,
  kNoVerdict,
};

/// One round of the loop as it went.
struct ImprovementStep {
  calibration::Diagnosis diagnosis;
  ImprovementReason reason = ImprovementReason::kNoVerdict;
  double first = std::numeric_limits<double>::quiet_NaN(), second = first;  ///< m, see ImprovementReason
  std::vector<std::string> added;                                           ///< none in the round that ended it
  std::vector<std::string> also;                           ///< what no reading could tell from one of those
  std::vector<std::string> not_needed;                     ///< members of a cause that the fit found to be none
  calibration::ErrorSize heldout_before, heldout_after;    ///< folds of poses kept out
  calibration::ErrorSize farthest_before, farthest_after;  ///< the quarter of the poses that reach farthest kept out
};

struct Improvement {
  ImprovementEnd end = ImprovementEnd::kNotRun;
  std::vector<ImprovementStep> steps;
  /// As given and as fitted first; one more for each step that added something. All are fitted to the same readings.
  std::vector<ImprovedModel> models;

  /// Whether there is a model that may be used.
  [[nodiscard]] bool isUsable() const {
    return !models.empty() && end != ImprovementEnd::kNotFitted &&
           !(end == ImprovementEnd::kInconclusive && models.size() == 1);
  }
};

/// Readings that determine nothing end it as not fitted, the fit refused. Throws JobStopped.
[[nodiscard]] Improvement improveModel(const CellModel& cell, const std::vector<calibration::Measurement>& readings,
                                       const ImprovementRequest& request, const WorkHooks& hooks = {});

/// The ladder of the models.
[[nodiscard]] std::vector<ModelComparisonRow> comparisonRowsOf(const Improvement& result);

}  // namespace tubeplan::app
