// What a plan, a proof or a count of steps is of: how its base came to stand where it stands.
#pragma once

#include <cstddef>
#include <string>

#include "app/studies/cell_model.hpp"
#include "calibration/estimation/base_calibration.hpp"

namespace tubeplan::app {

/// How a base was placed, as the rows of the table have it.
enum class BasePlacing { kNominal, kStated, kIdentified, kCalibrated, kMisfit, kEachRun };

struct BaseStanding {
  BasePlacing placing = BasePlacing::kNominal;
  std::size_t touches = 0;  ///< that placed it; of bases that each run calibrates none where their numbers differ
};

/// Returns how the base of a cell was placed: by `placed_by` where a calibration has just found it, else by what the
/// cell says of it.
[[nodiscard]] BaseStanding standingOf(const CellModel& cell, const calibration::BaseCalibration* placed_by = nullptr);

/// Returns the standing of the bases that runs calibrate, each run its own, by so many touches.
[[nodiscard]] inline BaseStanding standingOfEachRun(int touches) {
  return {BasePlacing::kEachRun, static_cast<std::size_t>(touches)};
}

/// Returns the name that documents have for it: "nominal", "calibrated", ...
[[nodiscard]] std::string nameOf(BasePlacing placing);

/// Returns whether somebody or something placed the base: all that is said of a nominal one is of where it should
/// stand.
[[nodiscard]] bool isPlaced(const BaseStanding& standing);

/// "for the nominal base; not calibrated", "for the base calibrated from 3 touches": continues "proved" and "steps".
[[nodiscard]] std::string wordsOf(const BaseStanding& standing);

/// Returns what to beware of, a sentence; empty for a base that may be relied on.
[[nodiscard]] std::string warningOf(const BaseStanding& standing);

}  // namespace tubeplan::app
