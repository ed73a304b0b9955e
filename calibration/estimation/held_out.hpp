// Validation of a fit on measurements that were not used for fitting. Measurements at the same posture or point are
// always held out together.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "calibration/estimation/fit.hpp"

namespace tubeplan::calibration {

/// Returns the group number of each measurement. Touches of the same point form a group, and so do other measurements
/// at the same posture.
[[nodiscard]] std::vector<int> groupByPose(const std::vector<Measurement>& measurements);

/// Returns the fold of each measurement, 0 to folds - 1. Whole groups are assigned at random, and those of each set-up
/// are spread evenly over the folds; there are fewer folds if there are fewer groups. Measurements with fold -1 are
/// never held out, because too few groups of their set-up would remain to determine its base.
[[nodiscard]] std::vector<int> foldsOf(const std::vector<Measurement>& measurements, int folds, std::uint64_t seed);

/// For each set-up, finds the quarter of its groups that reach farthest from the base. Returns fold 0 for their
/// measurements, and -1 (never held out) for all others. With these folds, cross-validation tests how well a fit
/// extrapolates.
[[nodiscard]] std::vector<int> farthestQuarter(const PlacedArm& placed, const std::vector<Measurement>& measurements);

/// Returns the measurements among `held_out` that a fit to the measurements `fitted` can predict. Excludes two kinds:
/// single touches of an unmeasured point, because the point is estimated from the touch itself; and measurements in a
/// set-up whose base is neither known nor fitted.
[[nodiscard]] std::vector<Measurement> judgeable(const PlacedArm& placed, const std::vector<Measurement>& fitted,
                                                 const std::vector<Measurement>& held_out);

/// Returns the errors of the measurements `judged` relative to the model `placed`. The positions of touched points that
/// were not measured are estimated from the same measurements.
[[nodiscard]] ErrorSize judge(const PlacedArm& placed, const std::vector<Measurement>& judged);

/// Function that returns the model fitted to the measurements `kept`; empty if they cannot be fitted.
using FitToMeasurements = std::function<std::optional<PlacedArm>(const std::vector<Measurement>& kept)>;

/// Predicts the measurements of each fold by a fit to the other folds, and returns the errors of all folds together. If
/// a fit fails, the number of measurements in the result is 0. Throws WorkStopped if a stop is requested.
[[nodiscard]] ErrorSize judgeFolds(const std::vector<Measurement>& measurements, const std::vector<int>& folds,
                                   const FitToMeasurements& fit, const WorkHooks& hooks = {});

/// Cross-validates by fits of the unknowns that start at `x`, and returns the held-out errors; without unknowns,
/// returns the errors of the model `start` itself.
[[nodiscard]] ErrorSize crossValidate(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                      const std::vector<Measurement>& measurements, const Eigen::VectorXd& x,
                                      const std::vector<int>& folds, const FitOptions& options,
                                      const WorkHooks& hooks = {});

/// Cross-validates like crossValidate(), but approximates each fold's fit by one Gauss-Newton step from `full_fit`, the
/// fit to all measurements. No robust loss is applied. Empty if measurements share noise, or if a fold's step exceeds
/// kFarthestFold or leaves the bounds.
[[nodiscard]] std::optional<ErrorSize> crossValidateBySteps(const PlacedArm& start,
                                                            const std::vector<Unknown>& unknowns,
                                                            const std::vector<Measurement>& measurements,
                                                            const Fit& full_fit, const std::vector<int>& folds,
                                                            const WorkHooks& hooks = {});

/// Largest step that a parameter may take, in its standard deviations in the fit to all measurements.
inline constexpr double kFarthestFold = 4;

}  // namespace tubeplan::calibration
