// Comparison of a model with readings: where it fails, by how much, and what its error follows. It is made with the
// model as it stands, and after a refit of the free numbers.
#pragma once

#include <string>
#include <vector>

#include "calibration/estimation/identification.hpp"
#include "calibration/estimation/repeats.hpp"
#include "calibration/patterns/joint_equivalents.hpp"
#include "calibration/patterns/pattern_search.hpp"

namespace tubeplan::calibration {

struct ComparisonOptions {
  IdentificationOptions refit;               ///< free numbers; may be none
  double level = kPatternLevel;              ///< level of each test by which a correct model may be said to fall short
  WorkHooks hooks;                           ///< also of the refit
  const Identification* refitted = nullptr;  ///< the refit, if it exists already
};

enum class ComparisonStatus { kNotRun, kDone, kRefused, kNotConverged, kStopped };

/// Verdict on a model. Inconclusive: the readings are too few, or their noise is stated too large, for a verdict.
enum class Adequacy { kNotRun, kAdequate, kInadequate, kInconclusive };

/// Returns "adequate", "falls-short", ...
[[nodiscard]] const char* nameOf(Adequacy adequacy);

/// Returns "The model falls short", ...
[[nodiscard]] const char* wordsOf(Adequacy adequacy);

/// Lack of fit of a model on the readings that a fit may use.
struct ModelLackOfFit {
  ErrorSize errors;
  double noise_floor = std::numeric_limits<double>::quiet_NaN();  ///< rms from noise alone [m]
  double chi2 = std::numeric_limits<double>::quiet_NaN();
  int degrees_of_freedom = 0;  ///< less the numbers that the readings determine; may be none
  double p_value = std::numeric_limits<double>::quiet_NaN();  ///< p-value by the stated noise
  std::string inconclusive;  ///< reason why the readings allow no verdict, and what is needed; empty if they do
  Repeats repeats;
  Adequacy adequacy = Adequacy::kNotRun;
};

/// One reading, in the order of the file.
struct ComparedReading {
  bool is_held_out = false;  ///< true: not used in the fit
  /// Predicted tip in the world [m].
  Eigen::Vector3d tip_before = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  Eigen::Vector3d tip_after = tip_before;
  /// Measured minus predicted, in the world [m]; for a distance along its line, for an unknown point from its estimate.
  Eigen::Vector3d error_before = tip_before, error_after = tip_before;
  double sigmas_before = std::numeric_limits<double>::quiet_NaN();  ///< length of the whitened error
  double sigmas_after = std::numeric_limits<double>::quiet_NaN();
  /// Length of the rotational part of the error [rad]; NaN if the reading measures no rotation.
  double turn_before = std::numeric_limits<double>::quiet_NaN();
  double turn_after = std::numeric_limits<double>::quiet_NaN();
};

struct Comparison {
  ComparisonStatus status = ComparisonStatus::kNotRun;
  std::string reason;                 ///< reason if not done
  std::vector<FreeProblem> problems;  ///< reasons if refused
  ModelLackOfFit as_it_stands, after_refit;
  Identification refit;  ///< the refit; not run if nothing is free
  PlacedArm fitted;      ///< the model after the refit
  std::vector<ComparedReading> readings;
  std::vector<int> worst;                        ///< indices of the fitted readings after the refit, most sigmas first
  PatternSearch patterns;                        ///< patterns of the lack of fit after the refit
  JointEquivalents joints_before, joints_after;  ///< columns in the order of `used`
  std::vector<int> used;                         ///< indices of readings that are not held out
  Adequacy verdict = Adequacy::kNotRun;          ///< after the refit
  std::vector<std::string> grounds;              ///< reasons for any verdict other than adequate, one clause each
  bool noise_disagrees = false;                  ///< true: repeats reject the stated noise, and are used instead
};

/// Returns the lack of fit of a fit on its own readings, judged as by compare(); not run if the model cannot be
/// evaluated there.
[[nodiscard]] ModelLackOfFit lackOfFitOf(const Identification& fit, const std::vector<Measurement>& readings,
                                         double level = kPatternLevel);

[[nodiscard]] Comparison compare(const PlacedArm& start, const std::vector<Measurement>& readings,
                                 const ComparisonOptions& options);

}  // namespace tubeplan::calibration
