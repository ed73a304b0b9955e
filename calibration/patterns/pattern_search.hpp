// Search for the variables that a residual follows, each by a statistical test.
//
// For a variable with functions f_j and axes e_c of a frame, the columns are W_i e_c(i) f_j(i), W_i the whitener of
// reading i. The components that the fitted unknowns, the touched points and a constant in that frame can absorb are
// projected off both columns and residual. The k columns then explain T of the residual's square R; F = (T / k) / ((R -
// T) / rest) has the F distribution if the residual is noise of any size. Holm's correction over all tests limits the
// chance of any false finding.
#pragma once

#include <string>
#include <vector>

#include "calibration/estimation/whitened_residual.hpp"
#include "calibration/hooks.hpp"
#include "calibration/patterns/pattern.hpp"

namespace tubeplan::calibration {

/// Axes of the components of an error.
enum class PatternFrame { kWorld, kRadial, kTool };

/// Mean over neighbouring values of the variable of the error's part that follows it.
struct TrendStep {
  double at = 0;          ///< mean value of the variable; for groups, the group's number
  Eigen::Vector3d error;  ///< mean error in the frame's axes [m]
  int readings = 0;
};

struct PatternTest {
  std::string kind;      ///< row of the table
  std::string variable;  ///< name of the variable
  deflection::ValueUnit unit;
  PatternFrame frame = PatternFrame::kWorld;
  double fall = 0;  ///< reduction of chi-square
  int numbers = 0;  ///< columns that were not absorbed
  int rest = 0;     ///< remaining degrees of freedom
  double F = std::numeric_limits<double>::quiet_NaN();
  double p_value = 1;      ///< p-value of this test alone
  double p_corrected = 1;  ///< over all tests (Holm)
  double share = 0;        ///< share of chi-square that it explains
  bool is_finding = false;
  std::string goes_with;            ///< stronger finding without which this would be none; empty if it is independent
  std::vector<TrendStep> trend;     ///< steps by rising value
  std::vector<std::string> groups;  ///< names of the groups, if the variable is a group
  int component = -1;               ///< component of the frame in which the trend is largest
  int low = -1, high = -1;          ///< steps of the trend with the least and the largest value of that component
  /// Difference between them [m]; for a constant, its root mean square.
  double size = std::numeric_limits<double>::quiet_NaN();
  double followed_rms = std::numeric_limits<double>::quiet_NaN();  ///< rms of the error that follows the variable [m]
};

struct PatternSearch {
  std::vector<PatternTest> tests;       ///< all tests, by p-value
  std::vector<PatternTest> findings;    ///< finding for each variable, in the frame that shows it best; strongest first
  std::vector<std::string> not_tested;  ///< variables that were not tested, and why
};

inline constexpr double kPatternLevel = 0.01;  ///< default level of a finding

/// Searches the patterns. `residual` is that of a fit, at its optimum, with the Jacobian by the fitted unknowns;
/// predicted minus measured. Throws WorkStopped if it was stopped.
[[nodiscard]] PatternSearch searchPatterns(const ReadingScene& scene, const ReadingWeights& weights,
                                           const WhitenedResidual& residual, double level, const WorkHooks& hooks = {});

}  // namespace tubeplan::calibration
