// Measurements that would tell apart the changes that a watch could not: a table of means, tried in the order of their
// cost.
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
  const char* words;  ///< what to do, for a reader
  int pairs = 0;      ///< pairs of answers that these measurements would probably tell apart
  int of_pairs = 0;   ///< pairs of answers
};

/// Returns the means that would tell apart the most pairs of the answers, the cheapest first of several; nullopt if
/// there are fewer than two answers or no means separates any pair. `visits` are the measurements since the change.
[[nodiscard]] std::optional<SeparatingMeans> separatingMeans(const WatchedArm& watched,
                                                             const std::vector<Measurement>& visits,
                                                             const ErrorState& state,
                                                             const std::vector<ChangeAnswer>& answers,
                                                             const StopQuestion& stop = {});

}  // namespace tubeplan::calibration
