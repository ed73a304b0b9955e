// Candidates for the next readings to distinguish explanations: of the kind, under the loads and in the conditions of
// the readings so far.
#pragma once

#include <cstdint>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/design/next_readings.hpp"
#include "calibration/placed_arm.hpp"

namespace tubeplan::app {

struct DiscriminationCandidateOptions {
  int postures = 48;  ///< number of postures or points
  int most_loads = 3;
  std::uint64_t seed = 1;
};

/// Returns candidates reached by the fitted model where it stood last. They are postures within the limits and clear of
/// the scene, or points of the readings and holes of the sheet. Without a scene, postures must be within the room of
/// the readings (measured_room.hpp). Approach directions are drawn at random if readings state them; conditions are the
/// middle of the readings' range, and the time is their last. Angles are proposed on the tool or on the rows on which
/// they were read.
[[nodiscard]] std::vector<calibration::ReadingCandidate> discriminationCandidates(
    const CellModel& cell, const calibration::PlacedArm& fitted, const std::vector<calibration::Measurement>& readings,
    const DiscriminationCandidateOptions& options = {});

}  // namespace tubeplan::app
