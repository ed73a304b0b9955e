// Readings that could be made next to split explanations: of the kind, under the loads and beside the conditions that
// the readings so far have.
#pragma once

#include <cstdint>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/design/next_readings.hpp"
#include "calibration/placed_arm.hpp"

namespace tubeplan::app {

struct DiscriminationCandidateOptions {
  int postures = 48;  ///< or points
  int most_loads = 3;
  std::uint64_t seed = 1;
};

/// Postures within the limits and clear of the scene, or where none is described within the room that the readings
/// took (measured_room.hpp), or points of the readings and holes of the sheet, reached by the
/// model as fitted where it stood last. Each has senses drawn at random where readings state them, the middle of their
/// conditions, and their last time. Angles are proposed on the tool or on the rows that they were read on.
[[nodiscard]] std::vector<calibration::ReadingCandidate> discriminationCandidates(
    const CellModel& cell, const calibration::PlacedArm& fitted, const std::vector<calibration::Measurement>& readings,
    const DiscriminationCandidateOptions& options = {});

}  // namespace tubeplan::app
