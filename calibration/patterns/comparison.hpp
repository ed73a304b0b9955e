// Where a model fails, by how much, and what its failing follows: as it stands, and after a refit of what is free.
#pragma once

#include <string>
#include <vector>

#include "calibration/estimation/identification.hpp"
#include "calibration/estimation/repeats.hpp"
#include "calibration/patterns/joint_equivalents.hpp"
#include "calibration/patterns/pattern_search.hpp"

namespace tubeplan::calibration {

struct ComparisonOptions {
  IdentificationOptions refit;   ///< what is free; nothing may be
  double level = kPatternLevel;  ///< of each ground on which a model that is right may be said to fall short
  WorkHooks hooks;               ///< of the refit too
  const Identification* refitted = nullptr;  ///< the refit, where it is made already
};

enum class ComparisonStatus { kNotRun, kDone, kRefused, kNotConverged, kStopped };

/// Inconclusive: the readings are too few, or their noise is stated too large, for a verdict.
enum class Adequacy { kNotRun, kAdequate, kInadequate, kInconclusive };

/// "adequate", "falls-short", ...
[[nodiscard]] const char* nameOf(Adequacy adequacy);

/// "The model falls short", ...
[[nodiscard]] const char* wordsOf(Adequacy adequacy);

/// A model against the readings that a fit may use.
struct ModelLackOfFit {
  ErrorSize errors;
  double noise_floor = std::numeric_limits<double>::quiet_NaN();  ///< rms that noise alone leaves [m]
  double chi2 = std::numeric_limits<double>::quiet_NaN();
  int degrees_of_freedom = 0;  ///< less the numbers that the readings determine; may be none
  double p_value = std::numeric_limits<double>::quiet_NaN();  ///< against the stated noise
  std::string inconclusive;  ///< why the readings can bear no verdict, and what would be needed; empty where they can
  Repeats repeats;
  Adequacy adequacy = Adequacy::kNotRun;
};

/// One reading, in the order of the file.
struct ComparedReading {
  bool is_held_out = false;  ///< then it was not fitted
  Eigen::Vector3d tip_before = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());  ///< m, world
  Eigen::Vector3d tip_after = tip_before;
  /// Measured less predicted, m, world; of a distance along its line; of an unknown point from its estimate.
  Eigen::Vector3d error_before = tip_before, error_after = tip_before;
  double sigmas_before = std::numeric_limits<double>::quiet_NaN();  ///< length of the whitened error
  double sigmas_after = std::numeric_limits<double>::quiet_NaN();
  /// Of what a reading measures of the tool's turn, the length of the error [rad]; not numbers where it measures none.
  double turn_before = std::numeric_limits<double>::quiet_NaN();
  double turn_after = std::numeric_limits<double>::quiet_NaN();
};

struct Comparison {
  ComparisonStatus status = ComparisonStatus::kNotRun;
  std::string reason;                 ///< why not done
  std::vector<FreeProblem> problems;  ///< why refused
  ModelLackOfFit as_it_stands, after_refit;
  Identification refit;  ///< not run where nothing is free
  PlacedArm fitted;      ///< the model after the refit
  std::vector<ComparedReading> readings;
  std::vector<int> worst;                        ///< of the fitted readings after the refit, most sigmas first
  PatternSearch patterns;                        ///< of the lack of fit after the refit
  JointEquivalents joints_before, joints_after;  ///< columns in the order of `used`
  std::vector<int> used;                         ///< readings that are not held out
  Adequacy verdict = Adequacy::kNotRun;          ///< after the refit
  std::vector<std::string> grounds;              ///< of any other verdict than adequate, one plain clause each
  bool noise_disagrees = false;                  ///< repeats say that the stated noise is wrong: they judge
};

/// Returns how a fit leaves the readings that it was made of, judged as compare() judges them; not run where the model
/// cannot be evaluated there.
[[nodiscard]] ModelLackOfFit lackOfFitOf(const Identification& fit, const std::vector<Measurement>& readings,
                                         double level = kPatternLevel);

[[nodiscard]] Comparison compare(const PlacedArm& start, const std::vector<Measurement>& readings,
                                 const ComparisonOptions& options);

}  // namespace tubeplan::calibration
