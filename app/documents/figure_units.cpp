#include "app/documents/figure_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ranges>

namespace tubeplan::app {

namespace {

using nlohmann::json;

/// Row that assigns a unit to JSON keys. A key matches the end of a value's path or, with a trailing slash, any part of
/// the path; with a leading slash it is the whole path or its beginning. The first matching row applies. `units` lists
/// paths at which the document states the unit's name; the first one found, searched from the value outwards, applies.
/// Text after "=" is itself the unit's name.
struct UnitRow {
  std::string_view units, keys;
};

constexpr UnitRow kUnitRows[] = {
    {"",
     "all_steps/ all_steps_after/ all_steps_before/ allowed_false_alarms alone/ bits/ by_size/size calibrated/ "
     "correlations/value delay/ detected/ false_alarms/ in_all_holes/ inconclusive/ lost/ missed/ named/ nothing "
     "probability/ refused/ repeats/ truth_among_answers/ wrong/"},
    {"units/length",
     "band/median band/p95 base/sigma centring_error/median centring_error/p95 compensated/max compensated/rms "
     "encoder_noise/median encoder_noise/p95 heldout_rms/with heldout_rms/without mean/sigma mean/value "
     "none/max none/rms patterns/size predicted_centring_error/median "
     "predicted_centring_error/p95 quantiles/ readings/after readings/before readings/explained "
     "scored/goal_point/error scored/none/error scored/via_point/error surfaces/rms tested/size tip/ tip_sigma/ "
     "tip_sigma_then/ trend/error worst/error"},
    {"unit units/length", "model_error/range model_error/value"},
    {"=of the joint", "encoder_sigma/ /end joint_corrections joints park posture/ /start"},
    {"units/angle", "angle base_turn_sigma fixed_angles rotation rpy tilt turn worst_tilt"},
    {"unit",
     "error_budget/explained filed high interval joints/encoder_sigma joints/home joints/lower joints/mean "
     "joints/spread joints/upper low modes neutral noise off plausible prior/sigma sigma/after sigma/now "
     "sigma/random sigma_before start total trend/at value values"},
    {"=of the shift and the turn", "covariance"},
    {"=of the length, and a fraction", "curve"},
    {"unit error_unit units/length", "remainder sigma size"},
    {"size_unit", "size_after size_before size_explained"},
    {"error_unit units/length",
     "after after_base as_it_stands before fitted floor heldout heldout_after heldout_before heldout_rms max mean "
     "model_error noise_floor rms worst"},
    {"units/length",
     "approach_deviation /base base_shift_sigma bodies/from bodies/outline bodies/point bodies/to by_arm center "
     "centre centring/offset centring_error clearance clearance/from clearance/margin clearance/to "
     "clearance_required deflection deflection_per_percent diameter diameters difference displacement distance dx "
     "dy error_after error_as_is error_before error_if_mended error_per_percent error_per_percent_base_known "
     "error_per_sigma extents/ followed_rms height hole hole_diameter holes/u holes/v holes/x holes/y holes/z "
     "insertion least_margin_proved least_play_in_tube lengths line_deviation mean_centring_error mean_deflection "
     "mean_touch_error mean_uncompensated_error measured min_clearance on_sheet padding/added pitch place "
     "play_in_tube position position_after position_before positions predicted_tip radius reach residual "
     "shapes/from shapes/outline shapes/point shapes/to shift step_tolerances tip tip_error tolerances "
     "touch_sigma uncompensated_per_percent unmodelled_sigma worst_approach_deviation worst_centring "
     "worst_centring_error worst_statics_difference /x /y"},
    {"units/force", "force force_base force_link load weight"},
    {"units/force*units/length", "moment moment_base moment_link"},
    {"=s", "lower_bound_s row_by_row_time_s total_time_s travel_time_s"},
    {"unit", "/readings/"}};

bool isAtEnd(std::string_view path, std::string_view key) {
  if (key.starts_with('/')) return key.ends_with('/') ? path.starts_with(key.substr(1)) : path == key.substr(1);
  const std::string within = fmt::format("/{}", path), at = fmt::format("/{}", key);
  return key.ends_with('/') ? within.find(at) != within.npos : within.ends_with(at);
}

template <class Each>
bool anyOf(std::string_view text, char mark, Each&& isTrueOf) {
  for (const auto part : std::views::split(text, mark))
    if (isTrueOf(std::string_view(part.begin(), part.end()))) return true;
  return false;
}

std::string nameAt(std::string_view path, std::span<const json* const> scopes) {
  const json::json_pointer pointer(fmt::format("/{}", path));
  for (const json* scope : std::views::reverse(scopes))
    if (scope->is_object() && scope->contains(pointer) && (*scope)[pointer].is_string())
      return (*scope)[pointer].get<std::string>();
  return "";
}

/// Returns the name of the unit that the document states at `paths`; several paths, separated by "*", give a product
/// such as "lbf*in".
std::string productAt(std::string_view paths, std::span<const json* const> scopes) {
  std::string product;
  (void)anyOf(paths, '*', [&](std::string_view path) {
    product += (product.empty() ? "" : "*") + nameAt(path, scopes);
    return false;
  });
  return product;
}

/// Returns the unit of a condition, which the document states under `units`; empty if the path names no condition.
std::string conditionUnit(std::string_view path, const json& document) {
  const json::json_pointer conditions("/units/conditions");
  if (!document.contains(conditions)) return "";
  for (const auto& condition : document[conditions])
    if (isAtEnd(path, condition.at("name").get<std::string>())) return condition.at("unit").get<std::string>();
  return "";
}

/// Returns the place of the row of kUnitRows that applies to a path; the number of rows if there is none.
std::size_t rowOf(std::string_view path) {
  const auto applies = [&](const UnitRow& row) {
    return anyOf(row.keys, ' ', [&](std::string_view key) { return isAtEnd(path, key); });
  };
  return static_cast<std::size_t>(std::ranges::find_if(kUnitRows, applies) - std::begin(kUnitRows));
}

std::string unitBy(std::size_t row, std::string_view path, std::span<const json* const> scopes) {
  std::string unit;
  if (row < std::size(kUnitRows)) {
    const std::string_view units = kUnitRows[row].units;
    if (units.starts_with('=')) return std::string(units.substr(1));
    (void)anyOf(units, ' ', [&](std::string_view unit_text) { return !(unit = productAt(unit_text, scopes)).empty(); });
  }
  if (unit.empty()) unit = conditionUnit(path, *scopes.front());
  return unit == "1" ? "" : unit;
}

}  // namespace

std::string figureUnit(std::string_view path, std::span<const json* const> scopes) {
  return unitBy(rowOf(path), path, scopes);
}

std::string FigureUnits::at(const std::string& path, std::span<const json* const> scopes) {
  const auto [row, is_new] = rows_.try_emplace(path);
  if (is_new) row->second = rowOf(path);
  return unitBy(row->second, path, scopes);
}

}  // namespace tubeplan::app
