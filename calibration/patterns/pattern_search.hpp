// Search for the variables on which a residual depends, each by a statistical test.
//
// For a variable with functions f_j and axes e_c of a frame, the columns are W_i e_c(i) f_j(i), where W_i is the
// whitener of measurement i. The components that the fitted unknowns, the touched points and a constant in the same
// frame can absorb are projected out of both columns and residual. The k columns then explain a part T of the
// residual's sum of squares R. F = (T / k) / ((R - T) / rest) has the F distribution if the residual is noise of any
// magnitude. Holm's correction over all tests limits the probability of any false finding.
#pragma once

#include <string>
#include <vector>

#include "calibration/estimation/whitened_residual.hpp"
#include "calibration/hooks.hpp"
#include "calibration/patterns/pattern.hpp"

namespace tubeplan::calibration {

/// Frame in whose axes an error is resolved.
enum class PatternFrame { kWorld, kRadial, kTool };

/// Error component that follows a variable, averaged over measurements with neighbouring values of the variable.
struct TrendStep {
  double at = 0;          ///< mean value of the variable; for groups, the index of the group
  Eigen::Vector3d error;  ///< mean error, in the axes of the frame [m]
  int measurements = 0;
};

struct PatternTest {
  std::string kind;      ///< name of the kind of pattern, as in patternKinds()
  std::string variable;  ///< name of the variable
  deflection::ValueUnit unit;
  PatternFrame frame = PatternFrame::kWorld;
  double fall = 0;            ///< reduction of chi-square by the pattern
  int numbers = 0;            ///< number of columns that were not absorbed
  int remaining_freedom = 0;  ///< remaining degrees of freedom
  double F = std::numeric_limits<double>::quiet_NaN();
  double p_value = 1;      ///< p-value of this test alone, without correction
  double p_corrected = 1;  ///< p-value after Holm's correction over all tests
  double share = 0;        ///< fraction of chi-square that the pattern explains
  bool is_finding = false;
  std::string goes_with;         ///< stronger finding that also explains this pattern; empty if there is none
  std::vector<TrendStep> trend;  ///< mean errors, in ascending order of the variable's value
  std::vector<std::string>
      groups;          ///< names of the groups, if the variable divides measurements into groups; else empty
  int component = -1;  ///< index of the frame's axis along which the trend is largest; -1 if none
  /// Indices of the trend steps with the smallest and the largest error along the frame's axis `component`; -1 if none.
  int low = -1, high = -1;
  /// Difference between the errors of the trend steps `high` and `low` [m]; for a constant, the root mean square error.
  double size = std::numeric_limits<double>::quiet_NaN();
  /// RMS of the error component that follows the variable [m].
  double followed_rms = std::numeric_limits<double>::quiet_NaN();
};

struct PatternSearch {
  std::vector<PatternTest> tests;  ///< all tests, smallest p-value first
  /// One finding per variable, in the frame that shows the dependence best; strongest first.
  std::vector<PatternTest> findings;
  std::vector<std::string> not_tested;  ///< variables that were not tested, and the reason
};

inline constexpr double kPatternLevel = 0.01;  ///< default significance level of a finding

/// Searches for patterns. `residual` is the residual of a fit at its optimum, predicted minus measured, with the
/// Jacobian with respect to the fitted unknowns. Throws WorkStopped if stopped.
[[nodiscard]] PatternSearch searchPatterns(const MeasurementScene& scene, const MeasurementWeights& weights,
                                           const WhitenedResidual& residual, double level, const WorkHooks& hooks = {});

}  // namespace tubeplan::calibration
