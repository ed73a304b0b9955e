#include "app/studies/positioning/base_standing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace tubeplan::app {

namespace {

struct PlacingRow {
  BasePlacing placing;
  const char *name, *words;  ///< `words` may contain {}, replaced by the number of touches
  const char* warning;       ///< warning with the same placeholder; empty if there is no warning
  bool is_placed;
};

constexpr PlacingRow kPlacings[] = {
    {BasePlacing::kNominal, "nominal", "for the nominal base; not calibrated",
     "the base is the cell's nominal one and was not calibrated: clearance, proofs and steps are valid only if the "
     "base is exactly there; touch three holes and calibrate (--touches)",
     false},
    {BasePlacing::kStated, "stated", "for the base that the cell states as known", "", true},
    {BasePlacing::kIdentified, "identified", "for the base found by a fit of readings", "", true},
    {BasePlacing::kCalibrated, "calibrated", "for the base calibrated from {}", "", true},
    {BasePlacing::kMisfit, "misfit", "for the base calibrated from {} that do not fit",
     "the base was calibrated from {} that do not fit: clearance, proofs and steps are valid only if the base is "
     "there; "
     "`tubeplan calibrate` shows what may be wrong",
     true},
    {BasePlacing::kEachRun, "each-run", "for the base that each run calibrates from {}", "", true}};

const PlacingRow& rowOf(BasePlacing placing) {
  return *std::ranges::find(kPlacings, placing, [](const PlacingRow& row) { return row.placing; });
}

std::string withTouches(const char* text, std::size_t touches) {
  const std::string count = touches == 0 ? "" : fmt::format("{} ", touches);
  return fmt::format(fmt::runtime(text), fmt::format("{}touch{}", count, touches == 1 ? "" : "es"));
}

}  // namespace

BaseStanding standingOf(const CellModel& cell, const calibration::BaseCalibration* placed_by) {
  if (placed_by)
    return {calibration::isFitRefused(*placed_by) ? BasePlacing::kMisfit : BasePlacing::kCalibrated,
            placed_by->residuals.size()};
  if (cell.placed_by) {
    const bool fits = !cell.model_error || cell.model_error->from != kByTouches;
    return {fits ? BasePlacing::kCalibrated : BasePlacing::kMisfit, cell.placed_by->touches.size()};
  }
  if (cell.base_known) return {BasePlacing::kStated};
  return {cell.base_covariance ? BasePlacing::kIdentified : BasePlacing::kNominal};
}

std::string nameOf(BasePlacing placing) { return rowOf(placing).name; }

bool isPlaced(const BaseStanding& standing) { return rowOf(standing.placing).is_placed; }

std::string wordsOf(const BaseStanding& standing) {
  return withTouches(rowOf(standing.placing).words, standing.touches);
}

std::string warningOf(const BaseStanding& standing) {
  return withTouches(rowOf(standing.placing).warning, standing.touches);
}

std::vector<std::string> misfitWarnings(std::uint64_t misfits, std::uint64_t runs) {
  if (misfits == 0) return {};
  return {
      fmt::format("in {} of {} runs the touches do not fit: `tubeplan calibrate` would report this; their steps are "
                  "counted as well",
                  misfits, runs)};
}

}  // namespace tubeplan::app
