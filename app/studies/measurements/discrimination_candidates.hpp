// Candidates for further measurements that could distinguish between explanations of a model's error. The candidates
// have the kind, loads and conditions of the measurements so far.
#pragma once

#include <cstdint>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/design/next_measurements.hpp"
#include "calibration/placed_arm.hpp"

namespace tubeplan::app {

struct DiscriminationCandidateOptions {
  /// Largest number of postures. Fewer than twice as many points are measured.
  int postures = 48;
  int most_loads = 3;
  std::uint64_t seed = 1;
};

/// Returns candidates that the fitted model reaches from the base of its last set-up. The candidates are postures
/// within the limits and clear of the scene, or reach the points measured so far and holes of the sheet. Without a
/// scene, postures must lie in the region that the measured postures show to be free (measured_room.hpp). Conditions
/// are the medians over the measurements; the time is that of the latest measurement. Approach directions are drawn at
/// random if the measurements state them. Angles are proposed for the tool or for the rows at which angles were
/// measured.
[[nodiscard]] std::vector<calibration::MeasurementCandidate> discriminationCandidates(
    const CellModel& cell, const calibration::PlacedArm& fitted,
    const std::vector<calibration::Measurement>& measurements, const DiscriminationCandidateOptions& options = {});

}  // namespace tubeplan::app
