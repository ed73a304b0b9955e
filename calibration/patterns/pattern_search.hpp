// Which variables a residual follows, each asked by a test, so that a pattern is a finding and not an impression.
//
// For a variable with functions f_j and axes e_c of a frame, the columns are W_i e_c(i) f_j(i), W_i the whitener of
// reading i. What the fitted unknowns, the touched points and a constant in that frame can absorb is projected off both
// columns and residual. The k columns then follow T of the residual's square R; F = (T / k) / ((R - T) / rest) has the
// F distribution where the residual is noise, whatever the noise's size. Holm's correction over all tests keeps the
// chance of any false finding.
#pragma once

#include <string>
#include <vector>

#include "calibration/estimation/whitened_residual.hpp"
#include "calibration/hooks.hpp"
#include "calibration/patterns/pattern.hpp"

namespace tubeplan::calibration {

/// In which axes the components of an error are taken.
enum class PatternFrame { kWorld, kRadial, kTool };

/// The mean of the error's part that follows the variable, over neighbouring values of it.
struct TrendStep {
  double at = 0;          ///< mean value of the variable; of groups: the group's number
  Eigen::Vector3d error;  ///< m, in the frame's axes
  int readings = 0;
};

struct PatternTest {
  std::string kind;      ///< row of the table
  std::string variable;  ///< its name
  deflection::ValueUnit unit;
  PatternFrame frame = PatternFrame::kWorld;
  double fall = 0;  ///< of chi-square
  int numbers = 0;  ///< columns that were not absorbed
  int rest = 0;     ///< degrees of freedom that remain
  double F = std::numeric_limits<double>::quiet_NaN();
  double p_value = 1;      ///< of this test alone
  double p_corrected = 1;  ///< over all tests (Holm)
  double share = 0;        ///< of chi-square that it follows
  bool is_finding = false;
  std::string goes_with;         ///< the stronger finding without which it would be none; empty where it stands alone
  std::vector<TrendStep> trend;  ///< by rising value
  std::vector<std::string> groups;  ///< names of the groups, where the variable is one
  int component = -1;               ///< of the frame, in which the trend is largest
  int low = -1, high = -1;          ///< steps of the trend where that component is least and most
  double size = std::numeric_limits<double>::quiet_NaN();  ///< m, between them; of a constant: its root mean square
  double followed_rms = std::numeric_limits<double>::quiet_NaN();  ///< m, of the error that follows the variable
};

struct PatternSearch {
  std::vector<PatternTest> tests;       ///< all of them, by p-value
  std::vector<PatternTest> findings;    ///< one for each variable, in the frame that shows it best; strongest first
  std::vector<std::string> not_tested;  ///< and why
};

inline constexpr double kPatternLevel = 0.01;  ///< of a finding, unless another is asked for

/// `residual` is that of a fit, at its optimum, with the Jacobian by what was fitted; predicted less measured. Unwinds
/// where it was stopped.
[[nodiscard]] PatternSearch searchPatterns(const ReadingScene& scene, const ReadingWeights& weights,
                                           const WhitenedResidual& residual, double level, const WorkHooks& hooks = {});

}  // namespace tubeplan::calibration
