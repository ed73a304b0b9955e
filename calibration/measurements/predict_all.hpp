// Prediction of many measurements in parallel on all cores.
#pragma once

#include <functional>

#include "calibration/hooks.hpp"
#include "calibration/measurements/measurement_prediction.hpp"

namespace tubeplan::deflection {
class Kinematics;
}

namespace tubeplan::calibration {

/// Returns true if the model of these measurements depends on joints, load and gravity only, so that their shapes can
/// be solved side by side (SIMD). This holds for arms without effects or with effects that only shift joints, tips that
/// carry only a hung load, and measurements that do not measure a row's frame.
[[nodiscard]] bool areForKernels(const deflection::Arm& arm, const std::vector<Measurement>& measurements);

/// Calls `each(k, prediction)` for every measurement, in any order and on any thread; measurement k is made at base
/// pose `base_pose_of[k]`. Returns false if a shape does not converge or `stop` requests a stop; some measurements are
/// then not predicted. `prepared`, if not null, must belong to the arm; passing it saves time if few measurements are
/// predicted for many base poses.
[[nodiscard]] bool predictAll(const PlacedArm& placed, const std::vector<Measurement>& measurements,
                              const std::vector<int>& base_pose_of, const PredictionRequest& request,
                              const StopQuestion& stop,
                              const std::function<void(std::size_t k, const Prediction& prediction)>& each,
                              deflection::Kinematics* prepared = nullptr);

}  // namespace tubeplan::calibration
