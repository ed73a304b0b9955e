// Mistakes that begin at one of the measurements: a lost zero, a changed tool, a displaced base.
//
// The errors of a fit are linear in the size of a step. The sums over the measurements that a step affects follow
// recursively from the sums for a step that begins one measurement later. A single pass over the measurements therefore
// gives the gain and the best size of a step at every measurement, with all open parameters of the drawing refitted (as
// in Andrews 1993, "Tests for parameter instability and structural change with unknown change point"). The best step of
// each form is then refined: a fit of its size alternates with a search for the measurement at which it begins. The
// choice of the measurement has a penalty: half the logarithm of the number of measured values for each parameter of
// the step (Schwarz 1978), and the logarithm of the number of measurements.
//
// Errors that change gradually (creep) with time, temperature, load, joints or row are not a step: if a function of one
// of these variables explains nearly as much, no step is proposed.
#pragma once

#include <vector>

#include "calibration/measurement_checks/mistake_trials.hpp"

namespace tubeplan::calibration {

/// Returns corrections of the most probable steps, at most one of each form, in measurements that are already corrected
/// by `before`. `open` is the fit of these measurements with all open parameters free. Empty if a creep explains the
/// errors.
[[nodiscard]] std::vector<Correction> likelySteps(const MistakeTrials& trials, const Correction& before,
                                                  const Trial& open);

}  // namespace tubeplan::calibration
