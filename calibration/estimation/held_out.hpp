// Prediction of readings that a fit has not used. Whole poses, points or set-ups are held out, never single rows of
// one.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "calibration/estimation/fit.hpp"

namespace tubeplan::calibration {

/// Returns the group of each reading: touches of one point, and readings at one posture, belong together.
[[nodiscard]] std::vector<int> groupByPose(const std::vector<Measurement>& readings);

/// Returns the fold of each reading, 0 to folds - 1. Whole groups are drawn by the seed, those of each set-up evenly
/// over the folds; there are fewer folds if there are fewer groups. -1: never held out, because the base of its set-up
/// would be left with too few groups.
[[nodiscard]] std::vector<int> foldsOf(const std::vector<Measurement>& readings, int folds, std::uint64_t seed);

/// Returns fold 0 for the quarter of the poses of each set-up that reach farthest from the base, -1 for the others,
/// which are never held out. This tests a fit outside its range.
[[nodiscard]] std::vector<int> farthestQuarter(const PlacedArm& placed, const std::vector<Measurement>& readings);

/// Returns the held-out readings that a fit to others can predict. A single touch of an unmeasured point is not among
/// them, because the point is estimated from that touch itself, nor are readings of a set-up that no fitted reading
/// places.
[[nodiscard]] std::vector<Measurement> judgeable(const PlacedArm& placed, const std::vector<Measurement>& fitted,
                                                 const std::vector<Measurement>& held_out);

/// Returns the errors of `judged` with the model as placed. Unmeasured touched points are estimated from the judged
/// readings themselves.
[[nodiscard]] ErrorSize judge(const PlacedArm& placed, const std::vector<Measurement>& judged);

/// Function that returns the model fitted to some readings, or nothing if it cannot be fitted.
using FitToReadings = std::function<std::optional<PlacedArm>(const std::vector<Measurement>& kept)>;

/// Judges each fold with a fit to the others, and returns all errors together; without errors if a fit fails. Throws
/// WorkStopped if it was stopped.
[[nodiscard]] ErrorSize judgeFolds(const std::vector<Measurement>& readings, const std::vector<int>& folds,
                                   const FitToReadings& fit, const WorkHooks& hooks = {});

/// Cross-validates the unknowns fitted from `x`; without unknowns, the model as it is.
[[nodiscard]] ErrorSize crossValidate(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                      const std::vector<Measurement>& readings, const Eigen::VectorXd& x,
                                      const std::vector<int>& folds, const FitOptions& options,
                                      const WorkHooks& hooks = {});

/// Cross-validates with each fold's fit replaced by one Gauss-Newton step from `whole`, the fit to all readings. There
/// is no robust loss, and the error is of second order in the step. Nothing if a fold is too far from the whole fit for
/// that (kFarthestFold).
[[nodiscard]] std::optional<ErrorSize> crossValidateBySteps(const PlacedArm& start,
                                                            const std::vector<Unknown>& unknowns,
                                                            const std::vector<Measurement>& readings, const Fit& whole,
                                                            const std::vector<int>& folds, const WorkHooks& hooks = {});

inline constexpr double kFarthestFold = 4;  ///< largest step, in standard deviations of the number by all readings

}  // namespace tubeplan::calibration
