// Mistakes that begin at one of the readings: a zero that was lost, a tool that was changed, a base that was bumped.
//
// What a fit leaves is linear in the size of a step, and the sums over all readings from one on follow from those of
// the next: one pass over the readings gives for each of them how much a step there would explain beyond all that the
// drawing leaves open, with the size that suits it best (as in Andrews 1993, "Tests for parameter instability and
// structural change with unknown change point"). The best of each form is then fitted, and its reading found by the
// errors of all readings before and after it, by turns. The choice of the reading has its price: half the logarithm of
// the numbers measured for each number of the step (Schwarz 1978), and the logarithm of the readings.
//
// What creeps with time, temperature, load, joints or row is no step: where a form that follows one of them explains
// nearly as much, none is proposed.
#pragma once

#include <vector>

#include "calibration/measurement_checks/mistake_trials.hpp"

namespace tubeplan::calibration {

/// The likeliest steps, one of each form at most, in readings that are taken as `before` has them; `open` is their
/// trial with all that is open. None where what creeps explains them.
[[nodiscard]] std::vector<Mend> likelySteps(const MistakeTrials& trials, const Mend& before, const Trial& open);

}  // namespace tubeplan::calibration
