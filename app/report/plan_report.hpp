// Report page of a plan: one self-contained HTML file made from one JSON document.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tubeplan::app {

/// Returns the page as one HTML document that needs no network, no other file and no server. The data is embedded so
/// that no text in it can end its script block; the page shows text as plain text only. Bytes that are not UTF-8 become
/// U+FFFD and numbers that are not finite become "not recorded". Equal reports give identical bytes.
///
/// Every part of `report` may be absent or null; the page then shows "not recorded". Lengths are in `units.length`
/// (such as "in"), angles in `units.angle`, times in seconds; a point is [x, y] in the frame of the tube sheet.
///   title, cell, version: text; seed: number or text; units: {length, angle}; summary: [[label, value], ...]
///   sheet: {name, leg, viewed_from: "below" or "above", hole_diameter, pitch, rows, columns,
///           holes: [[row, column, x, y, state], ...], fingerprint}
///   steps: [{diameter, tolerance}, ...], all steps of the calibration tool, step 1 first
///   tubes: [{order, row, column, x, y, tilt, predicted_error, steps, probability_by_steps, none, goal_point,
///           via_point}, ...] in visiting order; none, goal_point and via_point are the modes of compensation, each
///           {error, dx, dy, steps, approach_deviation}, or null without a truth
///   unreachable: [{row, column, x, y, reason}, ...];  tour: [[x, y], ...], path of the tip projected onto the sheet
///   touches: [{id, hole, row, column, x, y, residual: [3], sigma: [3]}, ...]
///   distances: [{from, to, by_arm, on_sheet, sigma}, ...]
///   calibration: {rms, chi2, degrees_of_freedom, p_value, base: {position, rpy}, base_sigma: {position, rotation}}
///   bowl_radius: radius of a sphere about the centre of the sheet
///   side_views: [{label, rigid, flexible, shapes: [{from, to, radius}], hole, world_centre, centre_aside}, ...],
///           points [r, z] in the vertical plane of the arm; the centre of the sheet is at world_centre and
///           centre_aside away from that plane
///   counts: {none, goal_point, via_point}, for each mode the number of tubes in which 0, 1, ... steps enter; counted
///           from `tubes` if absent
///   times: {travel_time_s, lower_bound_s, gap, row_by_row_time_s, total_time_s}, with gap as a fraction
///   min_clearance, clearance_required, tightest: text; clearance_along: [[time in s, clearance], ...]
[[nodiscard]] std::string renderPlanReport(const nlohmann::json& report);

}  // namespace tubeplan::app
