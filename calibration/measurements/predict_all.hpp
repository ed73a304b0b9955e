// Readings predicted on all cores.
#pragma once

#include <functional>

#include "calibration/hooks.hpp"
#include "calibration/measurements/reading_prediction.hpp"

namespace tubeplan::deflection {
class Kinematics;
}

namespace tubeplan::calibration {

/// Whether joints, load and gravity are all that matters to the model of any of the readings: arms without effects,
/// tips on which nothing but a load hangs, no frames of rows. Their shapes are solved side by side.
[[nodiscard]] bool areForKernels(const deflection::Arm& arm, const std::vector<Measurement>& readings);

/// Calls `each(k, prediction)` for every reading, the order and the thread left open; reading k is made at base pose
/// `base_pose_of[k]`. False where a shape does not converge, or as soon as it is asked to stop: some are left out then.
/// `prepared`, where not null, is of the arm, for few readings that are asked for at one base after another.
[[nodiscard]] bool predictAll(const PlacedArm& placed, const std::vector<Measurement>& readings,
                              const std::vector<int>& base_pose_of, const PredictionRequest& request,
                              const StopQuestion& stop,
                              const std::function<void(std::size_t k, const Prediction& prediction)>& each,
                              deflection::Kinematics* prepared = nullptr);

}  // namespace tubeplan::calibration
