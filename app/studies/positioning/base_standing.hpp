// The origin of a base's place, which qualifies plans, proofs and counts of steps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/estimation/base_calibration.hpp"

namespace tubeplan::app {

/// Kind of a base's placement, in the order of the table.
enum class BasePlacing { kNominal, kStated, kIdentified, kCalibrated, kMisfit, kEachRun };

struct BaseStanding {
  BasePlacing placing = BasePlacing::kNominal;
  std::size_t touches = 0;  ///< number that placed it; 0 for bases that each run calibrates with different numbers
};

/// Returns how the base of a cell was placed: by `placed_by` if a calibration has just found it, else as the cell
/// states.
[[nodiscard]] BaseStanding standingOf(const CellModel& cell, const calibration::BaseCalibration* placed_by = nullptr);

/// Returns the standing of bases that each run calibrates by its own touches.
[[nodiscard]] inline BaseStanding standingOfEachRun(int touches) {
  return {BasePlacing::kEachRun, static_cast<std::size_t>(touches)};
}

/// Returns a sentence of warning for runs whose touches do not fit; nothing if there are none.
[[nodiscard]] std::vector<std::string> misfitWarnings(std::uint64_t misfits, std::uint64_t runs);

/// Returns the name in documents: "nominal", "calibrated", ...
[[nodiscard]] std::string nameOf(BasePlacing placing);

/// Returns true if the base was placed by a measurement or a statement; results for a nominal base only hold for its
/// nominal place.
[[nodiscard]] bool isPlaced(const BaseStanding& standing);

/// Returns "for the nominal base; not calibrated", "for the base calibrated from 3 touches", to follow "proved" and
/// "steps".
[[nodiscard]] std::string wordsOf(const BaseStanding& standing);

/// Returns a sentence of warning; empty for a reliable base.
[[nodiscard]] std::string warningOf(const BaseStanding& standing);

}  // namespace tubeplan::app
