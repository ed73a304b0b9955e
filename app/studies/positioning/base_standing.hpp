// Origin of a base pose (nominal, stated, identified or calibrated), which qualifies plans, proofs and step counts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/estimation/base_calibration.hpp"

namespace tubeplan::app {

/// Method by which the base pose was determined, in the order of the table in base_standing.cpp.
enum class BasePlacing { kNominal, kStated, kIdentified, kCalibrated, kMisfit, kEachRun };

struct BaseStanding {
  BasePlacing placing = BasePlacing::kNominal;
  /// Number of touches that determined the base; 0 if touches did not determine it, or if the number differs between
  /// runs.
  std::size_t touches = 0;
};

/// Returns how the base was determined: by `placed_by` if a calibration has just been made, or else as the cell states.
[[nodiscard]] BaseStanding standingOf(const CellModel& cell, const calibration::BaseCalibration* placed_by = nullptr);

/// Returns the origin of base poses that each run calibrates from its own touches.
[[nodiscard]] inline BaseStanding standingOfEachRun(int touches) {
  return {BasePlacing::kEachRun, static_cast<std::size_t>(touches)};
}

/// Returns a warning about runs whose touches do not fit; empty if there are none.
[[nodiscard]] std::vector<std::string> misfitWarnings(std::uint64_t misfits, std::uint64_t runs);

/// Returns the name used in documents: "nominal", "calibrated", ...
[[nodiscard]] std::string nameOf(BasePlacing placing);

/// Returns true if the base was determined by a measurement or a statement. Results for a nominal base are valid only
/// if the base is exactly at its nominal pose.
[[nodiscard]] bool isPlaced(const BaseStanding& standing);

/// Returns a phrase to follow "proved" or "steps", such as "for the nominal base; not calibrated" or "for the base
/// calibrated from 3 touches".
[[nodiscard]] std::string wordsOf(const BaseStanding& standing);

/// Returns a warning about the base; empty if the base is reliable.
[[nodiscard]] std::string warningOf(const BaseStanding& standing);

}  // namespace tubeplan::app
