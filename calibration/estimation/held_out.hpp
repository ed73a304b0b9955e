// How well a fit predicts readings it has not seen: whole poses, points or set-ups are kept out, never single rows of
// one.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "calibration/estimation/fit.hpp"

namespace tubeplan::calibration {

/// Number of the group each reading belongs to: touches of one point, and readings at one posture, go together.
[[nodiscard]] std::vector<int> groupByPose(const std::vector<Measurement>& readings);

/// Fold of each reading, 0 to folds - 1, whole groups drawn by the seed, each set-up's shared out evenly; fewer folds
/// where there are fewer groups. -1: never kept out, of a set-up whose base would be left to a few groups.
[[nodiscard]] std::vector<int> foldsOf(const std::vector<Measurement>& readings, int folds, std::uint64_t seed);

/// Fold 0 for the quarter of the poses of each set-up that reach farthest from the base, -1 for the others, which are
/// never kept out: how a fit carries over to where it was not made.
[[nodiscard]] std::vector<int> farthestQuarter(const PlacedArm& placed, const std::vector<Measurement>& readings);

/// Those of the held-out readings that can be judged by a fit to others: not a lone touch of a point that nobody
/// measured, which is estimated from that touch itself, nor readings of a set-up that no fitted reading places.
[[nodiscard]] std::vector<Measurement> judgeable(const PlacedArm& placed, const std::vector<Measurement>& fitted,
                                                 const std::vector<Measurement>& held_out);

/// Errors of `judged` by the model as it is placed; touched points that nobody measured are estimated from the judged
/// readings themselves.
[[nodiscard]] ErrorSize judge(const PlacedArm& placed, const std::vector<Measurement>& judged);

/// The model as fitted to some readings; nothing where it cannot be.
using FitToReadings = std::function<std::optional<PlacedArm>(const std::vector<Measurement>& kept)>;

/// Each fold judged by a fit to the others; all errors together. Nothing where a fit fails. Unwinds where it was
/// stopped.
[[nodiscard]] ErrorSize judgeFolds(const std::vector<Measurement>& readings, const std::vector<int>& folds,
                                   const FitToReadings& fit, const WorkHooks& hooks = {});

/// The same with the unknowns fitted from `x`; with none, the model as it is.
[[nodiscard]] ErrorSize crossValidate(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                      const std::vector<Measurement>& readings, const Eigen::VectorXd& x,
                                      const std::vector<int>& folds, const FitOptions& options,
                                      const WorkHooks& hooks = {});

/// Each fold's fit as one Gauss-Newton step from `whole`, the fit to all readings: without a robust loss, and off by
/// the square of the step. Nothing where a fold is too far from the whole for that (kFarthestFold).
[[nodiscard]] std::optional<ErrorSize> crossValidateBySteps(const PlacedArm& start,
                                                            const std::vector<Unknown>& unknowns,
                                                            const std::vector<Measurement>& readings, const Fit& whole,
                                                            const std::vector<int>& folds, const WorkHooks& hooks = {});

inline constexpr double kFarthestFold = 4;  ///< of a step, in standard deviations of the number by all readings

}  // namespace tubeplan::calibration
