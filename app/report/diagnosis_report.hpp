// Pages about a model's errors, each one self-contained HTML file made from one JSON document.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tubeplan::app {

/// Returns the page of `tubeplan diagnose`. `report` is the command's --json output (diagnosis_json.hpp,
/// diagnosis_views_json.hpp) with the strings title, cell, measurements, seed and version; seed may be a number. Markup
/// in strings is harmless, as in renderPage(). Every part of `report` may be absent or null; the page then shows "not
/// recorded".
[[nodiscard]] std::string renderDiagnosisReport(const nlohmann::json& report);

/// Returns the page of `tubeplan compare`. Missing parts and markup are handled as in renderDiagnosisReport(). `report`
/// has
///   verdict, sentence: text; sentences: [text, ...]; units; chi2_per_dof, p_value; joints: [{name, unit}, ...]
///   rms: {before, after, heldout_before, heldout_after, noise_floor}
///   measurements: [{id, point, position: [3], before: [3], after: [3], joints, load, senses, temperature, time}, ...],
///             where before and after are the errors (measured minus predicted) before and after the fit
///   patterns: [text or {sentence or name, share or correlation, p_value}, ...]
///   worst: [id or {id, error, sigmas}, ...]
[[nodiscard]] std::string renderComparisonReport(const nlohmann::json& report);

/// Returns the page of `tubeplan ladder`. Missing parts and markup are handled as in renderDiagnosisReport(). `report`
/// has
///   units; noise_floor; models: [{name, rms, heldout_rms, chi2_per_dof, p_value, numbers}, ...];
///   measurements: as for renderComparisonReport()
[[nodiscard]] std::string renderLadderReport(const nlohmann::json& report);

/// Returns the page of `tubeplan improve` from the command's --json output, with `models` as for renderLadderReport().
/// Each step also has `figures`, the input of renderDiagnosisReport(). Missing parts and markup are handled as in
/// renderDiagnosisReport().
[[nodiscard]] std::string renderImprovementReport(const nlohmann::json& report);

/// Returns the page of `tubeplan report` from projectReportJson(). Missing parts and markup are handled as in
/// renderDiagnosisReport().
[[nodiscard]] std::string renderProjectReport(const nlohmann::json& report);

}  // namespace tubeplan::app
