// Measurements that discriminate between changes that a watch cannot distinguish: a table of means, in order of
// their cost.
//
// For answers a and b with their fitted numbers, the means' measurements differ by d = C_a t_a - C_b t_b in standard
// deviations of their noise. The covariance of what b predicts is S = I + H P H^T + C_b T_b C_b^T, with the errors P of
// base and parameters and the covariance T_b of b's numbers. The pair counts as separated if d^T S^-1 d is large both
// ways.
#pragma once

#include "calibration/watch/change_judgement.hpp"

namespace tubeplan::calibration {

struct SeparatingMeans {
  const char* name;   ///< key of the means
  const char* words;  ///< instruction to the user
  int pairs = 0;      ///< number of pairs of answers that these measurements probably separate
  int of_pairs = 0;   ///< number of all pairs of answers
};

/// Returns the means that separates the most pairs of answers, and of equal ones the cheapest; nullopt if
/// there are fewer than two answers or no means separates any pair. `visits` are the measurements since the change.
[[nodiscard]] std::optional<SeparatingMeans> separatingMeans(const WatchedArm& watched,
                                                             const std::vector<Measurement>& visits,
                                                             const ErrorState& state,
                                                             const std::vector<ChangeAnswer>& answers,
                                                             const StopQuestion& stop = {});

}  // namespace tubeplan::calibration
