// What a fit says of each number: its value with an interval, or why it is held, in one plain sentence.
#pragma once

#include "calibration/told_fit.hpp"

namespace tubeplan::calibration {

/// Fills `numbers` of those that were held, and ties their partners to them.
void sayHeld(const ToldFit& work, Identification& result);

/// Fills `numbers` of those that were fitted; their covariance and its widening must be there, and sayHeld() done.
void sayFitted(const ToldFit& work, Identification& result);

}  // namespace tubeplan::calibration
