// Comparison of a model with measurements: where the model fails, by how much, and which variables its error follows.
// The model is compared both unchanged and after a refit of the free parameters.
#pragma once

#include <string>
#include <vector>

#include "calibration/estimation/identification.hpp"
#include "calibration/estimation/repeats.hpp"
#include "calibration/patterns/joint_equivalents.hpp"
#include "calibration/patterns/pattern_search.hpp"

namespace tubeplan::calibration {

struct ComparisonOptions {
  IdentificationOptions refit;   ///< options of the refit, which is skipped if no parameter is free
  double level = kPatternLevel;  ///< significance level of each test: probability that the test rejects a correct model
  WorkHooks hooks;               ///< hooks of the comparison, also used by the refit
  /// Existing result of the refit; if null, compare() does the refit.
  const Identification* refitted = nullptr;
};

enum class ComparisonStatus { kNotRun, kDone, kRefused, kNotConverged, kStopped };

/// Verdict on a model. kInconclusive: the measurements are too few, or their stated noise is too large, for a verdict.
enum class Adequacy { kNotRun, kAdequate, kInadequate, kInconclusive };

/// Returns the name of a verdict, such as "adequate" or "falls-short".
[[nodiscard]] const char* nameOf(Adequacy adequacy);

/// Returns a verdict as a clause, such as "The model falls short".
[[nodiscard]] const char* wordsOf(Adequacy adequacy);

/// Lack of fit of a model to the measurements that are not held out.
struct ModelLackOfFit {
  ErrorSize errors;
  double noise_floor = std::numeric_limits<double>::quiet_NaN();  ///< rms error due to noise alone [m]
  double chi2 = std::numeric_limits<double>::quiet_NaN();
  /// Number of measured values less the number of parameters that they determine; can be zero or negative.
  int degrees_of_freedom = 0;
  double p_value = std::numeric_limits<double>::quiet_NaN();  ///< p-value of chi-square with the stated noise
  /// Reason why no verdict is possible on the measurements, and the data needed for one; empty if there is a verdict.
  std::string inconclusive;
  Repeats repeats;
  Adequacy adequacy = Adequacy::kNotRun;
};

/// Comparison of one measurement with the model before and after the refit.
struct ComparedMeasurement {
  bool is_held_out = false;  ///< true if the measurement was not used in the fit
  /// Predicted tip in the world frame [m], before and after the refit.
  Eigen::Vector3d tip_before = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  Eigen::Vector3d tip_after = tip_before;
  /// Measured minus predicted value, in the world frame [m]. The error of a distance is along its line, the error at an
  /// unknown point relative to the point's estimate.
  Eigen::Vector3d error_before = tip_before, error_after = tip_before;
  /// Length of the whitened error, in standard deviations.
  double sigmas_before = std::numeric_limits<double>::quiet_NaN();
  double sigmas_after = std::numeric_limits<double>::quiet_NaN();
  /// Length of the rotational part of the error [rad]; NaN if the measurement measures no rotation.
  double turn_before = std::numeric_limits<double>::quiet_NaN();
  double turn_after = std::numeric_limits<double>::quiet_NaN();
};

struct Comparison {
  ComparisonStatus status = ComparisonStatus::kNotRun;
  std::string reason;                 ///< reason if the status is not kDone
  std::vector<FreeProblem> problems;  ///< names that cannot be freed, if the status is kRefused
  ModelLackOfFit as_it_stands, after_refit;
  Identification refit;  ///< result of the refit; kNotRun if nothing is free
  PlacedArm fitted;      ///< the model after the refit
  std::vector<ComparedMeasurement> measurements;
  std::vector<int> worst;  ///< indices of the fitted measurements, largest whitened error after the refit first
  PatternSearch patterns;  ///< patterns in the residual after the refit
  /// Residual converted to joint corrections, before and after the refit; columns in the order of `used`.
  JointEquivalents joints_before, joints_after;
  std::vector<int> used;                 ///< indices of the measurements that are not held out
  Adequacy verdict = Adequacy::kNotRun;  ///< verdict after the refit
  std::vector<std::string> grounds;      ///< reasons for any verdict other than kAdequate, one clause each
  /// True if the scatter of repeats contradicts the stated noise and replaces it.
  bool noise_disagrees = false;
};

/// Returns the lack of fit of an identified model to its own measurements, as judged by compare(). The adequacy is
/// kNotRun if the model cannot be evaluated.
[[nodiscard]] ModelLackOfFit lackOfFitOf(const Identification& fit, const std::vector<Measurement>& measurements,
                                         double level = kPatternLevel);

[[nodiscard]] Comparison compare(const PlacedArm& start, const std::vector<Measurement>& measurements,
                                 const ComparisonOptions& options);

}  // namespace tubeplan::calibration
