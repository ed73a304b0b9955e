// The plan's report page: one self-contained HTML file, made from one JSON document.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tubeplan::app {

/// Returns the whole page as one HTML document that needs no network, no other file and no server. The data is embedded
/// so that no text in it can end its script block; the page shows text as text only. Bytes that are not UTF-8 become
/// U+FFFD and numbers that are not finite become "not recorded". The same document gives the same bytes.
///
/// Every part of `report` may be absent or null; the page then shows "not recorded". Lengths are in
/// `units.length` (as "in"), angles in `units.angle`, times in seconds; a point is [x, y] in the sheet's frame.
///   title, cell, version: text; seed: number or text; units: {length, angle}; summary: [[label, value], ...]
///   sheet: {name, leg, viewed_from: "below" | "above", hole_diameter, pitch, rows, columns,
///           holes: [[row, column, x, y, state], ...], fingerprint}
///   steps: [{diameter, tolerance}, ...]   the calibration tool's steps, as many as it has, step 1 first
///   tubes: [{order, row, column, x, y, tilt, predicted_error, steps, probability_by_steps, none, goal_point,
///   via_point}]
///          in visiting order; each mode {error, dx, dy, steps, approach_deviation}, or null without a truth
///   unreachable: [{row, column, x, y, reason}];  tour: [[x, y], ...] the tip's trace in the sheet's plane
///   touches: [{id, hole, row, column, x, y, residual: [3], sigma: [3]}]
///   distances: [{from, to, by_arm, on_sheet, sigma}]
///   calibration: {rms, chi2, degrees_of_freedom, p_value, base: {position, rpy}, base_sigma: {position, rotation}}
///   bowl_radius: of a sphere about the sheet's centre
///   side_views: [{label, rigid, flexible, shapes: [{from, to, radius}], hole, world_centre, centre_aside}]
///          points [r, z] in the arm's vertical plane; the sheet's centre lies centre_aside beside it, at world_centre
///   counts: {none, goal_point, via_point}: tubes by number of steps, 0 to all; counted from `tubes` when absent
///   times: {travel_time_s, lower_bound_s, gap, row_by_row_time_s, total_time_s}, gap as a fraction
///   min_clearance, clearance_required, tightest: text, clearance_along: [[time in s, clearance], ...]
[[nodiscard]] std::string renderPlanReport(const nlohmann::json& report);

}  // namespace tubeplan::app
