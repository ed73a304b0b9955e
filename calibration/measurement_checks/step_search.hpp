// Mistakes that begin at one of the readings: a lost zero, a changed tool, a displaced base.
//
// The errors of a fit are linear in the size of a step, and the sums over all readings from one reading on follow
// recursively from the sums from the next reading on. A single pass over the readings therefore yields, for a step at
// each reading, its gain and its best size, given all parameters that the drawing leaves open (as in Andrews 1993,
// "Tests for parameter instability and structural change with unknown change point"). The best step of each form is
// then fitted, alternating with a search for its first reading by the errors of all readings before and after. The
// choice of the reading has a penalty: half the logarithm of the number of measured values for each parameter of the
// step (Schwarz 1978), and the logarithm of the number of readings.
//
// Errors that change gradually (creep) with time, temperature, load, joints or row are not a step: if a function of one
// of these variables explains nearly as much, no step is proposed.
#pragma once

#include <vector>

#include "calibration/measurement_checks/mistake_trials.hpp"

namespace tubeplan::calibration {

/// Returns the most probable steps, at most one of each form, in readings corrected by `before`. `open` is the trial of
/// these readings with all open parameters free. Empty if a creep explains the errors.
[[nodiscard]] std::vector<Mend> likelySteps(const MistakeTrials& trials, const Mend& before, const Trial& open);

}  // namespace tubeplan::calibration
