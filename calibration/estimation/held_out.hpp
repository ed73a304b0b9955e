// Validation of a fit by readings that the fit has not used. Whole poses, points or set-ups are held out, never single
// readings of a pose.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "calibration/estimation/fit.hpp"

namespace tubeplan::calibration {

/// Returns the group number of each reading. Touches of the same point, and readings at the same posture, form a group.
[[nodiscard]] std::vector<int> groupByPose(const std::vector<Measurement>& readings);

/// Returns the fold of each reading, 0 to folds - 1. Whole groups are assigned at random, and those of each set-up are
/// spread evenly over the folds; there are fewer folds if there are fewer groups. -1: never held out, because too few
/// groups would remain to determine the base of the set-up.
[[nodiscard]] std::vector<int> foldsOf(const std::vector<Measurement>& readings, int folds, std::uint64_t seed);

/// Returns fold 0 for the quarter of each set-up's poses that reach farthest from the base, and -1 for all other
/// readings, which are never held out. These folds test a fit outside its range.
[[nodiscard]] std::vector<int> farthestQuarter(const PlacedArm& placed, const std::vector<Measurement>& readings);

/// Returns the held-out readings that a fit to other readings can predict. Excluded are single touches of an unmeasured
/// point, because the point is estimated from the touch itself, and readings of a set-up whose base is neither known
/// nor determined by fitted readings.
[[nodiscard]] std::vector<Measurement> judgeable(const PlacedArm& placed, const std::vector<Measurement>& fitted,
                                                 const std::vector<Measurement>& held_out);

/// Returns the errors of the readings `judged` for the model as placed. The positions of unmeasured touched points are
/// estimated from the same readings.
[[nodiscard]] ErrorSize judge(const PlacedArm& placed, const std::vector<Measurement>& judged);

/// Function that returns the model fitted to the readings `kept`; empty if they cannot be fitted.
using FitToReadings = std::function<std::optional<PlacedArm>(const std::vector<Measurement>& kept)>;

/// Predicts each fold from a fit to the other folds, and returns the errors of all folds together; the result has no
/// readings if a fit fails. Throws WorkStopped if stopped.
[[nodiscard]] ErrorSize judgeFolds(const std::vector<Measurement>& readings, const std::vector<int>& folds,
                                   const FitToReadings& fit, const WorkHooks& hooks = {});

/// Returns the held-out errors of fits of the unknowns that start at `x`; without unknowns, those of the model as it
/// is.
[[nodiscard]] ErrorSize crossValidate(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                      const std::vector<Measurement>& readings, const Eigen::VectorXd& x,
                                      const std::vector<int>& folds, const FitOptions& options,
                                      const WorkHooks& hooks = {});

/// Cross-validates with each fold's fit replaced by one Gauss-Newton step from `whole`, the fit to all readings. No
/// robust loss is applied, and the error is of second order in the step. Empty if readings share noise, or if a fold's
/// fit is too far from `whole` for a single step (kFarthestFold).
[[nodiscard]] std::optional<ErrorSize> crossValidateBySteps(const PlacedArm& start,
                                                            const std::vector<Unknown>& unknowns,
                                                            const std::vector<Measurement>& readings, const Fit& whole,
                                                            const std::vector<int>& folds, const WorkHooks& hooks = {});

inline constexpr double kFarthestFold = 4;  ///< largest step of a parameter, in the standard deviations of `whole`

}  // namespace tubeplan::calibration
