// Effects that the free parameters of a fit reproduce at every posture of the arm, such as an offset of the tool where
// the tip is free. Together with these parameters, their sizes would be determined only by priors.
#pragma once

#include <vector>

#include "calibration/diagnosis/causes/cause.hpp"
#include "calibration/diagnosis/causes/signatures.hpp"

namespace tubeplan::calibration {

/// Removes from `list` the effects that the fitted parameters reproduce to a thousandth of their motion of the tool, at
/// random postures under the conditions of the measurements. Adds them to CauseList::not_tried and returns true if any
/// was removed. `signatures` are those of the causes in the list. Removes nothing if the arm cannot be evaluated.
/// Throws WorkStopped on a request to stop.
bool removeRepeated(const PlacedArm& placed, const std::vector<Measurement>& measurements,
                    const std::vector<Unknown>& fitted, const Signatures& signatures, CauseList& list,
                    const StopQuestion& stop = {});

}  // namespace tubeplan::calibration
