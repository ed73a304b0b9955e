// Diagnose, add, identify, until nothing more is sure: from a cell and its readings to the improved cell.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/files/reading_input.hpp"
#include "app/studies/job_steps.hpp"
#include "app/studies/model/model_comparison.hpp"
#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::app {

/// A model on the way, fitted: as given, and after each step.
struct ImprovedModel {
  std::string name;  ///< "as given", "+ backlash@tool.z"
  Cell cell;         ///< with what was added; its numbers are those of `fit`
  calibration::Identification fit;
};

struct ImprovementRequest {
  int steps = 6;  ///< the most that add something
  std::uint64_t seed = 1;
  std::function<void(const ImprovedModel&)> on_model;  ///< told of every model once it is fitted
};

enum class ImprovementEnd {
  kNotRun,
  kAdequate,          ///< nothing is missing
  kNothingSure,       ///< something is, and no cause lowers the error where it was not fitted
  kAmbiguous,         ///< alternatives differ over the arm's range by more than the first gains
  kDoesNotCarryOver,  ///< the cause does not lower the error of readings kept out, or of the farthest poses
  kMistake,           ///< a mistake with the readings explains the error
  kInconclusive,      ///< the readings allow no verdict
  kMostSteps,
  kNotFitted,  ///< the model as given cannot be fitted
};

/// One round of the loop as it went.
struct ImprovementStep {
  calibration::Verdict verdict = calibration::Verdict::kNotRun;
  std::string sentence;                                    ///< of the diagnosis
  std::vector<std::string> added;                          ///< none in the round that ended it
  std::vector<std::string> also;                           ///< what no reading could tell from one of those
  std::string reason;                                      ///< why it was added, or why the loop ends here
  calibration::ErrorSize heldout_before, heldout_after;    ///< folds of poses kept out
  calibration::ErrorSize farthest_before, farthest_after;  ///< the quarter of the poses that reach farthest kept out
};

struct Improvement {
  ImprovementEnd end = ImprovementEnd::kNotRun;
  std::vector<ImprovementStep> steps;
  std::vector<ImprovedModel> models;  ///< as given and as fitted first; one more for each step that added something

  /// Whether there is a model that may be used.
  [[nodiscard]] bool isUsable() const {
    return !models.empty() && end != ImprovementEnd::kNotFitted &&
           !(end == ImprovementEnd::kInconclusive && models.size() == 1);
  }
};

/// Throws InputError for readings from which nothing can be fitted, JobStopped.
[[nodiscard]] Improvement improveModel(const CellReadings& input, const ImprovementRequest& request,
                                       const WorkHooks& hooks = {});

/// "adequate", "nothing-sure", ...
[[nodiscard]] const char* nameOf(ImprovementEnd end);

/// As `tubeplan improve --json` writes it.
[[nodiscard]] nlohmann::json improvementJson(const Improvement& result, const Units& units);

/// The ladder of the models.
[[nodiscard]] std::vector<ModelComparisonRow> comparisonRowsOf(const Improvement& result);

}  // namespace tubeplan::app
