// Mistakes that begin at one of the readings: a lost zero, a changed tool, a displaced base.
//
// The errors of a fit are linear in the size of a step, and the sums over all readings from one on follow from those of
// the next. So one pass over the readings gives for each the gain and the best size of a step there, beyond all that
// the drawing leaves open (as in Andrews 1993, "Tests for parameter instability and structural change with unknown
// change point"). The best step of each form is then fitted, alternating with a search for its reading by the errors of
// all readings before and after it. The choice of the reading has a penalty: half the logarithm of the numbers measured
// for each number of the step (Schwarz 1978), and the logarithm of the number of readings.
//
// Errors that creep with time, temperature, load, joints or row are no step: if a form that follows one of them
// explains nearly as much, none is proposed.
#pragma once

#include <vector>

#include "calibration/measurement_checks/mistake_trials.hpp"

namespace tubeplan::calibration {

/// Returns the likeliest steps, at most one of each form, in readings corrected by `before`; `open` is their trial with
/// all that is open. Empty if a creep explains the errors.
[[nodiscard]] std::vector<Mend> likelySteps(const MistakeTrials& trials, const Mend& before, const Trial& open);

}  // namespace tubeplan::calibration
