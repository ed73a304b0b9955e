// The pages about a model's errors, each one self-contained HTML file made from one JSON document.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tubeplan::app {

/// Returns the whole page of `tubeplan diagnose`, from its --json output (diagnosis_json.hpp, diagnosis_views_json.hpp)
/// with title, cell, measurements, seed, version: text (seed: number or text). Safe for hostile text as renderPage().
/// Every part of `report` may be absent or null; the page then shows "not recorded".
[[nodiscard]] std::string renderDiagnosisReport(const nlohmann::json& report);

/// Returns the page of `tubeplan compare`, by the same rules, from
///   verdict, sentence: text; sentences: [text, ...]; units; rms: {before, after, heldout_before, heldout_after,
///   noise_floor}; chi2_per_dof, p_value; joints: [{name, unit}, ...]   readings: [{id, point, position: [3], before:
///   [3], after: [3], joints, load, senses,
///                                             temperature, time}, ...], errors as measured less predicted
///   patterns: [text or {sentence or name, share or correlation, p_value}, ...]   worst: [id or {id, error, sigmas},
///   ...]
[[nodiscard]] std::string renderComparisonReport(const nlohmann::json& report);

/// Returns the page of `tubeplan ladder`, by the same rules, from
///   units; noise_floor; models: [{name, rms, heldout_rms, chi2_per_dof, p_value, numbers}, ...], readings as in
///   renderComparisonReport()
[[nodiscard]] std::string renderLadderReport(const nlohmann::json& report);

/// Returns the page of `tubeplan improve`, by the same rules, from its --json output, with models as for a ladder and,
/// for each step, `figures`: the input of the page of a diagnosis.
[[nodiscard]] std::string renderImprovementReport(const nlohmann::json& report);

/// Returns the page of `tubeplan report`, by the same rules, from projectReportJson().
[[nodiscard]] std::string renderProjectReport(const nlohmann::json& report);

}  // namespace tubeplan::app
